#include "meshing/quality.h"

#include "meshing/curving.h"
#include "meshing/half_edge_mesh.h"
#include "meshing/measures.h"
#include "meshing/triangle_search.h"
#include "model/numerics/lagrange.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <set>
#include <vector>

namespace sbeh::meshing {

using Eigen::Vector3d;

namespace {

void measure_corners(const TriangleMesh& mesh, Quality& q) {
  q.min_angle = 180;
  double shortest = std::numeric_limits<double>::infinity(), longest = 0;
  std::vector<int> valence(std::size_t(mesh.point_count()), 0);
  for (const auto c : mesh.triangles.colwise())
    for (int k = 0; k < 3; ++k) {
      const Vector3d tip = mesh.points.col(c[k]);
      const Vector3d u = mesh.points.col(c[(k + 1) % 3]) - tip;
      const Vector3d v = mesh.points.col(c[(k + 2) % 3]) - tip;
      const double angle = std::atan2(u.cross(v).norm(), u.dot(v)) * 180 / std::numbers::pi;
      q.min_angle = std::min(q.min_angle, angle);
      q.max_angle = std::max(q.max_angle, angle);
      shortest = std::min(shortest, u.norm());
      longest = std::max(longest, u.norm());
      ++valence[std::size_t(c[k])];
    }
  q.edge_ratio = longest / shortest;
  for (const int v : valence) ++q.valences[v];
}

// At the nodes of all orders and points between: the Jacobian is a polynomial of degree 4 for P3.
Eigen::Matrix2Xd jacobian_points() {
  constexpr int parts = 6;
  Eigen::Matrix2Xd x(2, (parts + 1) * (parts + 2) / 2);
  int column = 0;
  for (int i = 0; i <= parts; ++i)
    for (int j = 0; i + j <= parts; ++j) x.col(column++) << double(i) / parts, double(j) / parts;
  return x;
}

void measure_jacobian(const CurvedMesh& mesh, Quality& q) {
  const model::TriangleElement element(mesh.order);
  std::vector<Eigen::MatrixX2d> dphi;
  const Eigen::Matrix2Xd points = jacobian_points();
  for (const auto x : points.colwise()) dphi.emplace_back(element.derivatives(x).transpose());
  q.min_jacobian = std::numeric_limits<double>::infinity();
  q.max_jacobian = -q.min_jacobian;
  for (int t = 0; t < mesh.triangle_count(); ++t) {
    const Eigen::Matrix3Xd X = mesh.nodes(Eigen::all, mesh.triangles.col(t));
    const Vector3d plain = (X.col(1) - X.col(0)).cross(X.col(2) - X.col(0));
    for (const auto& d : dphi) {
      const Eigen::Matrix<double, 3, 2> dX = X * d;
      const double J = dX.col(0).cross(dX.col(1)).dot(plain) / plain.squaredNorm();
      if (J < q.min_jacobian) q.worst_triangle = t;
      q.min_jacobian = std::min(q.min_jacobian, J);
      q.max_jacobian = std::max(q.max_jacobian, J);
    }
  }
}

void measure_intersections(const CurvedMesh& mesh, Quality& q) {
  const int parts = mesh.order * mesh.order;
  std::set<std::array<int, 2>> pairs;
  for (const auto& [a, b] : self_intersections(lattice(mesh))) pairs.insert({a / parts, b / parts});
  q.self_intersections = int(pairs.size());
  if (!pairs.empty()) q.first_pair = *pairs.begin();
}

}  // namespace

std::vector<Eigen::Vector3i> small_triangles(int order) {
  if (order == 1) return {{0, 1, 2}};
  if (order == 2) return {{0, 3, 5}, {3, 1, 4}, {5, 4, 2}, {3, 4, 5}};
  return {{0, 3, 8}, {3, 9, 8}, {3, 4, 9}, {4, 5, 9}, {4, 1, 5},
          {8, 9, 7}, {9, 6, 7}, {9, 5, 6}, {7, 6, 2}};
}

TriangleMesh lattice(const CurvedMesh& mesh) {
  const std::vector<Eigen::Vector3i> small = small_triangles(mesh.order);
  TriangleMesh fine{mesh.nodes,
                    Eigen::Matrix3Xi(3, mesh.triangle_count() * Eigen::Index(small.size()))};
  Eigen::Index column = 0;
  for (const auto c : mesh.triangles.colwise())
    for (const Eigen::Vector3i& s : small) fine.triangles.col(column++) = c(s);
  return fine;
}

double min_jacobian(const CurvedMesh& mesh) {
  Quality q;
  measure_jacobian(mesh, q);
  return q.min_jacobian;
}

Quality quality_of(const CurvedMesh& mesh) {
  Quality q;
  q.triangles = mesh.triangle_count();
  q.area = area(mesh);
  q.volume = volume(mesh);
  q.reduced_volume = reduced_volume(q.area, q.volume);
  const TriangleMesh plain = corners(mesh);
  measure_corners(plain, q);
  measure_jacobian(mesh, q);
  measure_intersections(mesh, q);
  const HalfEdgeMesh half_edges = half_edge_mesh(plain);
  q.euler = int(half_edges.n_vertices()) - int(half_edges.n_edges()) + int(half_edges.n_faces());
  return q;
}

}  // namespace sbeh::meshing
