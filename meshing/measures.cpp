#include "meshing/measures.h"

#include "model/numerics/lagrange.h"
#include "model/numerics/quadrature.h"

#include <Eigen/Geometry>

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <vector>

namespace sbeh::meshing {

namespace {

struct ShapeAtPoint {
  double weight;
  Eigen::VectorXd phi;    // nodes of the element
  Eigen::MatrixX2d dphi;  // nodes of the element x 2
};

std::vector<ShapeAtPoint> tabulate(int order, int degree) {
  const model::TriangleElement element(order);
  const model::TriangleRule rule = model::triangle_rule(degree);
  std::vector<ShapeAtPoint> table;
  for (int q = 0; q < rule.size(); ++q)
    table.push_back({rule.weights[q], element.values(rule.points.col(q)),
                     element.derivatives(rule.points.col(q)).transpose()});
  return table;
}

constexpr int area_degree = 12;
// X·(X_1 × X_2) is a polynomial of this degree.
int volume_degree(int order) { return 3 * order - 2; }

Eigen::Matrix3Xd nodes_of(const CurvedMesh& mesh, int triangle) {
  return mesh.nodes(Eigen::all, mesh.triangles.col(triangle));
}

}  // namespace

double area(const CurvedMesh& mesh) {
  const auto table = tabulate(mesh.order, area_degree);
  double sum = 0;
  for (int t = 0; t < mesh.triangle_count(); ++t) {
    const Eigen::Matrix3Xd X = nodes_of(mesh, t);
    for (const ShapeAtPoint& q : table) {
      const Eigen::Matrix<double, 3, 2> dX = X * q.dphi;
      sum += q.weight * dX.col(0).cross(dX.col(1)).norm();
    }
  }
  return sum;
}

double volume(const CurvedMesh& mesh) {
  const auto table = tabulate(mesh.order, volume_degree(mesh.order));
  double sum = 0;
  for (int t = 0; t < mesh.triangle_count(); ++t) {
    const Eigen::Matrix3Xd X = nodes_of(mesh, t);
    for (const ShapeAtPoint& q : table) {
      const Eigen::Matrix<double, 3, 2> dX = X * q.dphi;
      sum += q.weight * (X * q.phi).dot(dX.col(0).cross(dX.col(1)));
    }
  }
  return sum / 3;
}

double reduced_volume(double area, double volume) {
  return 6 * std::sqrt(std::numbers::pi) * volume / std::pow(area, 1.5);
}

double reduced_volume(const CurvedMesh& mesh) { return reduced_volume(area(mesh), volume(mesh)); }

Eigen::Matrix3Xd area_gradient(const CurvedMesh& mesh) {
  const auto table = tabulate(mesh.order, area_degree);
  Eigen::Matrix3Xd gradient = Eigen::Matrix3Xd::Zero(3, mesh.node_count());
  for (int t = 0; t < mesh.triangle_count(); ++t) {
    const Eigen::Matrix3Xd X = nodes_of(mesh, t);
    for (const ShapeAtPoint& q : table) {
      const Eigen::Matrix<double, 3, 2> dX = X * q.dphi;
      const Eigen::Vector3d n = dX.col(0).cross(dX.col(1)).normalized();
      Eigen::Matrix<double, 3, 2> by_dX;
      by_dX << dX.col(1).cross(n), n.cross(dX.col(0));
      gradient(Eigen::all, mesh.triangles.col(t)) += q.weight * by_dX * q.dphi.transpose();
    }
  }
  return gradient;
}

Eigen::Matrix3Xd volume_gradient(const CurvedMesh& mesh) {
  // On a closed surface the three factors of X·(X_1 × X_2) contribute equally.
  const auto table = tabulate(mesh.order, volume_degree(mesh.order));
  Eigen::Matrix3Xd gradient = Eigen::Matrix3Xd::Zero(3, mesh.node_count());
  for (int t = 0; t < mesh.triangle_count(); ++t) {
    const Eigen::Matrix3Xd X = nodes_of(mesh, t);
    for (const ShapeAtPoint& q : table) {
      const Eigen::Matrix<double, 3, 2> dX = X * q.dphi;
      gradient(Eigen::all, mesh.triangles.col(t)) +=
          q.weight * dX.col(0).cross(dX.col(1)) * q.phi.transpose();
    }
  }
  return gradient;
}

void scale_to_area(CurvedMesh& mesh, double wanted) {
  if (!(wanted > 0)) throw std::invalid_argument("scale_to_area: the area must be > 0");
  mesh.nodes *= std::sqrt(wanted / area(mesh));
}

}  // namespace sbeh::meshing
