#include "meshing/curvature.h"

#include "model/numerics/lagrange.h"
#include "model/numerics/quadrature.h"

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <array>
#include <vector>

namespace sbeh::meshing {

namespace {

// Shape functions and their derivatives at one point of the reference triangle.
struct Shape {
  double weight = 0;
  Eigen::VectorXd phi;
  Eigen::MatrixX2d d;                      // ∂_1, ∂_2
  std::array<Eigen::VectorXd, 3> d_twice;  // ∂_11, ∂_12, ∂_22
};

// ∂_a φ_i is a polynomial of lower degree, hence its own interpolant: its derivative is exact.
Shape shape_at(const model::TriangleElement& element, const Eigen::Vector2d& x, double weight) {
  Shape s{.weight = weight,
          .phi = element.values(x),
          .d = element.derivatives(x).transpose(),
          .d_twice = {}};
  const Eigen::Matrix2Xd nodes = element.nodes();
  Eigen::MatrixXd at_nodes_1(element.size(), element.size()), at_nodes_2 = at_nodes_1;
  for (int j = 0; j < element.size(); ++j) {
    const Eigen::Matrix2Xd d = element.derivatives(nodes.col(j));
    at_nodes_1.col(j) = d.row(0);
    at_nodes_2.col(j) = d.row(1);
  }
  s.d_twice = {at_nodes_1 * s.d.col(0), at_nodes_1 * s.d.col(1), at_nodes_2 * s.d.col(1)};
  return s;
}

SurfacePoint surface_point(const Eigen::Matrix3Xd& X, int triangle, const Shape& s) {
  const Eigen::Matrix<double, 3, 2> dX = X * s.d;
  const Eigen::Matrix2d g = dX.transpose() * dX, inverse = g.inverse();
  const Eigen::Vector3d N = dX.col(0).cross(dX.col(1)), n = N.normalized();
  Eigen::Matrix2d h;
  h(0, 0) = n.dot(X * s.d_twice[0]);
  h(0, 1) = h(1, 0) = n.dot(X * s.d_twice[1]);
  h(1, 1) = n.dot(X * s.d_twice[2]);
  return {.triangle = triangle,
          .dS = s.weight * N.norm(),
          .x = X * s.phi,
          .n = n,
          .H = (inverse * h).trace(),
          .K = h.determinant() / g.determinant(),
          .phi = s.phi,
          .surface_grad = dX * inverse * s.d.transpose()};
}

}  // namespace

void for_each_point(const CurvedMesh& mesh, int degree,
                    const std::function<void(const SurfacePoint&)>& visit) {
  const model::TriangleElement element(mesh.order);
  const model::TriangleRule rule = model::triangle_rule(degree);
  std::vector<Shape> shapes;
  for (int q = 0; q < rule.size(); ++q)
    shapes.push_back(shape_at(element, rule.points.col(q), rule.weights[q]));
  for (int t = 0; t < mesh.triangle_count(); ++t) {
    const Eigen::Matrix3Xd X = mesh.nodes(Eigen::all, mesh.triangles.col(t));
    for (const Shape& s : shapes) visit(surface_point(X, t, s));
  }
}

CurvatureIntegrals curvature_integrals(const CurvedMesh& mesh) {
  constexpr int degree = 12;
  CurvatureIntegrals sum;
  for_each_point(mesh, degree, [&](const SurfacePoint& p) {
    sum.H += p.H * p.dS;
    sum.H_squared += p.H * p.H * p.dS;
    sum.K += p.K * p.dS;
  });
  return sum;
}

Eigen::VectorXd node_mean_curvature(const CurvedMesh& mesh) {
  const model::TriangleElement element(mesh.order);
  const Eigen::Matrix2Xd nodes = element.nodes();
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(mesh.node_count()), count = sum;
  for (Eigen::Index k = 0; k < nodes.cols(); ++k) {
    const Shape s = shape_at(element, nodes.col(k), 1);
    for (int t = 0; t < mesh.triangle_count(); ++t) {
      const int node = mesh.triangles(k, t);
      sum[node] += surface_point(mesh.nodes(Eigen::all, mesh.triangles.col(t)), t, s).H;
      count[node] += 1;
    }
  }
  return sum.cwiseQuotient(count);
}

}  // namespace sbeh::meshing
