#include "meshing/curvature.h"

#include "meshing/measures.h"
#include "model/numerics/lagrange.h"
#include "model/numerics/quadrature.h"

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <vector>

namespace sbeh::meshing {

namespace {

// Shape functions and their derivatives at one point of the reference triangle.
struct Shape {
  double weight;
  Eigen::VectorXd phi;
  Eigen::MatrixX2d d;  // ∂_1, ∂_2
};

Shape shape_at(const model::TriangleElement& element, const Eigen::Vector2d& x, double weight) {
  return {weight, element.values(x), element.derivatives(x).transpose()};
}

SurfacePoint surface_point(const Eigen::Matrix3Xd& X, const Eigen::Matrix3Xd& normals, int triangle,
                           const Shape& s) {
  const Eigen::Matrix<double, 3, 2> dX = X * s.d;
  const Eigen::Matrix2d g = dX.transpose() * dX;
  const Eigen::Vector3d N = dX.col(0).cross(dX.col(1)), n = N.normalized();
  SurfacePoint p{.triangle = triangle,
                 .dS = s.weight * N.norm(),
                 .x = X * s.phi,
                 .n = n,
                 .B = {},
                 .phi = s.phi,
                 .surface_grad = dX * g.inverse() * s.d.transpose()};
  const Eigen::Matrix3d P = Eigen::Matrix3d::Identity() - n * n.transpose();
  const Eigen::Matrix3d L = -P * (normals * p.surface_grad.transpose()) * P;
  p.B = (L + L.transpose()) / 2;
  return p;
}

}  // namespace

void for_each_point(const CurvedMesh& mesh, int degree,
                    const std::function<void(const SurfacePoint&)>& visit) {
  const model::TriangleElement element(mesh.order);
  const model::TriangleRule rule = model::triangle_rule(degree);
  std::vector<Shape> shapes;
  for (int q = 0; q < rule.size(); ++q)
    shapes.push_back(shape_at(element, rule.points.col(q), rule.weights[q]));
  const Eigen::Matrix3Xd normals = node_normals(mesh);
  for (int t = 0; t < mesh.triangle_count(); ++t) {
    const Eigen::Matrix3Xd X = mesh.nodes(Eigen::all, mesh.triangles.col(t));
    const Eigen::Matrix3Xd n = normals(Eigen::all, mesh.triangles.col(t));
    for (const Shape& s : shapes) visit(surface_point(X, n, t, s));
  }
}

Eigen::VectorXd node_mean_curvature(const CurvedMesh& mesh) {
  const model::TriangleElement element(mesh.order);
  const Eigen::Matrix2Xd nodes = element.nodes();
  const Eigen::Matrix3Xd normals = node_normals(mesh);
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(mesh.node_count()), count = sum;
  for (Eigen::Index k = 0; k < nodes.cols(); ++k) {
    const Shape s = shape_at(element, nodes.col(k), 1);
    for (int t = 0; t < mesh.triangle_count(); ++t) {
      const int node = mesh.triangles(k, t);
      sum[node] += surface_point(mesh.nodes(Eigen::all, mesh.triangles.col(t)),
                                 normals(Eigen::all, mesh.triangles.col(t)), t, s)
                       .H();
      count[node] += 1;
    }
  }
  return sum.cwiseQuotient(count);
}

}  // namespace sbeh::meshing
