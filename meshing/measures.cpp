#include "meshing/measures.h"

#include "model/numerics/lagrange.h"
#include "model/numerics/quadrature.h"

#include <Eigen/Geometry>

#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

namespace sbeh::meshing {

namespace {

// Shape functions of an element at all quadrature points.
struct ShapeTable {
  Eigen::VectorXd weight;  // points
  Eigen::MatrixXd phi;     // nodes of the element x points
  Eigen::MatrixXd dphi_1;  // nodes of the element x points
  Eigen::MatrixXd dphi_2;
};

ShapeTable tabulate(int order, int degree) {
  const model::TriangleElement element(order);
  const model::TriangleRule rule = model::triangle_rule(degree);
  const Eigen::MatrixXd zero(element.size(), rule.size());
  ShapeTable table{.weight = rule.weights, .phi = zero, .dphi_1 = zero, .dphi_2 = zero};
  for (int q = 0; q < rule.size(); ++q) {
    table.phi.col(q) = element.values(rule.points.col(q));
    const Eigen::Matrix2Xd d = element.derivatives(rule.points.col(q));
    table.dphi_1.col(q) = d.row(0);
    table.dphi_2.col(q) = d.row(1);
  }
  return table;
}

// Positions, tangents and area vectors of a curved triangle at the quadrature points, 3 x points.
struct ElementGeometry {
  Eigen::Matrix3Xd nodes, x, X_1, X_2, N;  // N = X_1 × X_2
  void evaluate(const CurvedMesh& mesh, int triangle, const ShapeTable& table) {
    nodes = mesh.nodes(Eigen::all, mesh.triangles.col(triangle));
    x.noalias() = nodes * table.phi;
    X_1.noalias() = nodes * table.dphi_1;
    X_2.noalias() = nodes * table.dphi_2;
    N.resize(3, x.cols());
    for (Eigen::Index q = 0; q < x.cols(); ++q)
      N.col(q) = Eigen::Vector3d(X_1.col(q)).cross(Eigen::Vector3d(X_2.col(q)));
  }
};

constexpr int area_degree = 12;
// X·(X_1 × X_2) is a polynomial of this degree.
int volume_degree(int order) { return 3 * order - 2; }

}  // namespace

double area(const CurvedMesh& mesh) {
  const ShapeTable table = tabulate(mesh.order, area_degree);
  ElementGeometry g;
  double sum = 0;
  for (int t = 0; t < mesh.triangle_count(); ++t) {
    g.evaluate(mesh, t, table);
    sum += g.N.colwise().norm().dot(table.weight);
  }
  return sum;
}

// From the middle of the nodes: far from the surface the parts would be much larger than their sum.
double volume(const CurvedMesh& mesh) {
  const ShapeTable table = tabulate(mesh.order, volume_degree(mesh.order));
  const Eigen::Vector3d middle = mesh.nodes.rowwise().mean();
  ElementGeometry g;
  double sum = 0;
  for (int t = 0; t < mesh.triangle_count(); ++t) {
    g.evaluate(mesh, t, table);
    sum += (g.x.colwise() - middle).cwiseProduct(g.N).colwise().sum().dot(table.weight);
  }
  return sum / 3;
}

double area(const TriangleMesh& mesh) {
  double sum = 0;
  for (const auto c : mesh.triangles.colwise()) {
    const Eigen::Vector3d a = mesh.points.col(c[0]);
    sum += (mesh.points.col(c[1]) - a).cross(mesh.points.col(c[2]) - a).norm() / 2;
  }
  return sum;
}

double volume(const TriangleMesh& mesh) {
  const Eigen::Vector3d middle = mesh.points.rowwise().mean();
  double sum = 0;
  for (const auto c : mesh.triangles.colwise()) {
    const Eigen::Matrix3d x = mesh.points(Eigen::all, c).colwise() - middle;
    sum += x.col(0).dot(x.col(1).cross(x.col(2))) / 6;
  }
  return sum;
}

Eigen::Vector3d centre(const CurvedMesh& mesh) {
  const ShapeTable table = tabulate(mesh.order, area_degree);
  const Eigen::Vector3d middle = mesh.nodes.rowwise().mean();
  ElementGeometry g;
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  double area = 0;
  for (int t = 0; t < mesh.triangle_count(); ++t) {
    g.evaluate(mesh, t, table);
    const Eigen::RowVectorXd dA = g.N.colwise().norm().cwiseProduct(table.weight.transpose());
    sum += (g.x.colwise() - middle) * dA.transpose();
    area += dA.sum();
  }
  return middle + sum / area;
}

double reduced_volume(const CurvedMesh& mesh) { return reduced_volume(area(mesh), volume(mesh)); }

Eigen::Matrix3Xd area_gradient(const CurvedMesh& mesh) {
  const ShapeTable table = tabulate(mesh.order, area_degree);
  ElementGeometry g;
  Eigen::Matrix3Xd gradient = Eigen::Matrix3Xd::Zero(3, mesh.node_count()), by_X_1, by_X_2;
  for (int t = 0; t < mesh.triangle_count(); ++t) {
    g.evaluate(mesh, t, table);
    by_X_1.resize(3, table.weight.size());
    by_X_2.resize(3, table.weight.size());
    for (Eigen::Index q = 0; q < table.weight.size(); ++q) {
      const Eigen::Vector3d n = g.N.col(q).normalized(), X_1 = g.X_1.col(q), X_2 = g.X_2.col(q);
      by_X_1.col(q) = table.weight[q] * X_2.cross(n);
      by_X_2.col(q) = table.weight[q] * n.cross(X_1);
    }
    gradient(Eigen::all, mesh.triangles.col(t)) +=
        by_X_1 * table.dphi_1.transpose() + by_X_2 * table.dphi_2.transpose();
  }
  return gradient;
}

Eigen::Matrix3Xd volume_gradient(const CurvedMesh& mesh) {
  // On a closed surface the three factors of X·(X_1 × X_2) contribute equally.
  const ShapeTable table = tabulate(mesh.order, volume_degree(mesh.order));
  ElementGeometry g;
  Eigen::Matrix3Xd gradient = Eigen::Matrix3Xd::Zero(3, mesh.node_count());
  for (int t = 0; t < mesh.triangle_count(); ++t) {
    g.evaluate(mesh, t, table);
    gradient(Eigen::all, mesh.triangles.col(t)) +=
        g.N * table.weight.asDiagonal() * table.phi.transpose();
  }
  return gradient;
}

Eigen::Matrix3Xd node_normals(const CurvedMesh& mesh) {
  const model::TriangleElement element(mesh.order);
  const Eigen::Matrix2Xd at = element.nodes();
  Eigen::Matrix3Xd normals = Eigen::Matrix3Xd::Zero(3, mesh.node_count());
  for (Eigen::Index k = 0; k < at.cols(); ++k) {
    const Eigen::MatrixX2d dphi = element.derivatives(at.col(k)).transpose();
    for (int t = 0; t < mesh.triangle_count(); ++t) {
      const Eigen::Matrix<double, 3, 2> dX = mesh.nodes(Eigen::all, mesh.triangles.col(t)) * dphi;
      normals.col(mesh.triangles(k, t)) += dX.col(0).cross(dX.col(1)).normalized();
    }
  }
  normals.colwise().normalize();
  return normals;
}

Eigen::Matrix3Xd point_normals(const TriangleMesh& mesh) {
  Eigen::Matrix3Xd normals = Eigen::Matrix3Xd::Zero(3, mesh.point_count());
  for (const auto c : mesh.triangles.colwise()) {
    const Eigen::Vector3d a = mesh.points.col(c[0]);
    const Eigen::Vector3d n = (mesh.points.col(c[1]) - a).cross(mesh.points.col(c[2]) - a);
    for (const int corner : c) normals.col(corner) += n;
  }
  normals.colwise().normalize();
  return normals;
}

bool correct_area_volume(CurvedMesh& mesh, double wanted_area, double wanted_reduced_volume) {
  constexpr int iterations = 30;
  const Eigen::Matrix3Xd n = node_normals(mesh);
  const double longest = 0.1 * std::sqrt(area(mesh) / (4 * std::numbers::pi));
  CurvedMesh moved = mesh;
  double way = 0, previous = std::numeric_limits<double>::infinity();
  for (int i = 0; i < iterations; ++i) {
    const double A = area(moved), V = volume(moved), v = reduced_volume(A, V);
    const double miss = wanted_reduced_volume / v - 1;
    // Rounding is reached when Newton's method gains no more.
    if (std::abs(miss) < 1e-12 && std::abs(miss) >= std::abs(previous)) {
      scale_to_area(moved, wanted_area);
      mesh = moved;
      return true;
    }
    previous = miss;
    const double dA = area_gradient(moved).cwiseProduct(n).sum();
    const double dV = volume_gradient(moved).cwiseProduct(n).sum();
    way += miss / (dV / V - 1.5 * dA / A);
    if (!(std::abs(way) < longest)) return false;
    moved.nodes = mesh.nodes + way * n;
  }
  return false;
}

void scale_to_area(CurvedMesh& mesh, double wanted) {
  if (!(wanted > 0)) throw std::invalid_argument("scale_to_area: the area must be > 0");
  mesh.nodes *= std::sqrt(wanted / area(mesh));
}

}  // namespace sbeh::meshing
