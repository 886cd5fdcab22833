#include "meshing/icosphere.h"

#include "meshing/mesh_symmetry.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <stdexcept>
#include <utility>
#include <vector>

namespace sbeh::meshing {

namespace {

// Vertex 0 on top, 1 … 5 the upper ring, 6 … 10 the lower ring, 11 below.
TriangleMesh icosahedron() {
  TriangleMesh mesh{Eigen::Matrix3Xd(3, 12), Eigen::Matrix3Xi(3, 20)};
  const double height = 1 / std::sqrt(5.), radius = 2 * height;
  mesh.points.col(0) << 0, 0, 1;
  mesh.points.col(11) << 0, 0, -1;
  for (int k = 0; k < 5; ++k) {
    const double upper = 2 * std::numbers::pi * k / 5, lower = upper + std::numbers::pi / 5;
    mesh.points.col(1 + k) << radius * std::cos(upper), radius * std::sin(upper), height;
    mesh.points.col(6 + k) << radius * std::cos(lower), radius * std::sin(lower), -height;
    const int next = (k + 1) % 5;
    mesh.triangles.col(4 * k) << 0, 1 + k, 1 + next;
    mesh.triangles.col(4 * k + 1) << 1 + k, 6 + k, 1 + next;
    mesh.triangles.col(4 * k + 2) << 6 + k, 6 + next, 1 + next;
    mesh.triangles.col(4 * k + 3) << 11, 6 + next, 6 + k;
  }
  return mesh;
}

// Vertices above and below, rings of `corners` around them, one of each ring at y = 0, and another ring on the equator: all rings have five or six
// triangles at each vertex.
TriangleMesh lantern(int corners) {
  constexpr double height = 0.6;  // of the rings, over the equator
  const double radius = std::sqrt(1 - height * height), step = 2 * std::numbers::pi / corners;
  TriangleMesh mesh{Eigen::Matrix3Xd(3, 3 * corners + 2), Eigen::Matrix3Xi(3, 6 * corners)};
  const int above = 3 * corners, below = above + 1;
  mesh.points.col(above) << 0, 0, 1;
  mesh.points.col(below) << 0, 0, -1;
  for (int k = 0; k < corners; ++k) {
    const double angle = k * step, between = (k + 0.5) * step;
    const int upper = k, lower = corners + k, middle = 2 * corners + k;
    const int next = (k + 1) % corners, before = (k + corners - 1) % corners;
    mesh.points.col(upper) << radius * std::cos(angle), radius * std::sin(angle), height;
    mesh.points.col(lower) << radius * std::cos(angle), radius * std::sin(angle), -height;
    mesh.points.col(middle) << std::cos(between), std::sin(between), 0;
    auto triangle = mesh.triangles.middleCols<6>(6 * k);
    triangle.col(0) << above, upper, next;
    triangle.col(1) << below, corners + next, lower;
    triangle.col(2) << upper, middle, next;
    triangle.col(3) << lower, corners + next, middle;
    triangle.col(4) << upper, 2 * corners + before, middle;
    triangle.col(5) << lower, middle, 2 * corners + before;
  }
  return mesh;
}

TriangleMesh octahedron() {
  TriangleMesh mesh{Eigen::Matrix3Xd(3, 6), Eigen::Matrix3Xi(3, 8)};
  mesh.points << Eigen::Matrix3d::Identity(), -Eigen::Matrix3d::Identity();
  int t = 0;
  for (const int x : {0, 3})
    for (const int y : {1, 4})
      for (const int z : {2, 5}) {
        const bool turned = (x + y + z) % 2 == 0;  // an odd number of mirrors
        mesh.triangles.col(t++) << x, turned ? z : y, turned ? y : z;
      }
  return mesh;
}

// Indices of the points of a mesh under refinement, shared by the triangles at an edge.
class SharedPoints {
 public:
  SharedPoints(const Eigen::Matrix3Xd& corners, int n) : n_(n) {
    for (Eigen::Index i = 0; i < corners.cols(); ++i) points_.emplace_back(corners.col(i));
  }

  /// The point with lattice weights (n − i − j, i, j)/n in the triangle abc; made when it is new.
  int index(const Eigen::Vector3i& abc, int i, int j) {
    const std::array<int, 3> weight{n_ - i - j, i, j};
    std::vector<std::pair<int, int>> key;  // (corner, weight): the same from either side of an edge
    for (int k = 0; k < 3; ++k)
      if (weight[k] > 0) key.emplace_back(abc[k], weight[k]);
    if (key.size() == 1) return key[0].first;
    std::sort(key.begin(), key.end());
    if (key.size() == 2) {
      const auto [place, is_new] = on_edges_.try_emplace(
          std::array{key[0].first, key[1].first, key[0].second}, int(points_.size()));
      if (!is_new) return place->second;
    }
    Eigen::Vector3d x = Eigen::Vector3d::Zero();
    for (const auto& [corner, w] : key) x += points_[corner] * (double(w) / n_);
    points_.push_back(x);
    return int(points_.size()) - 1;
  }

  Eigen::Matrix3Xd all() const {
    Eigen::Matrix3Xd matrix(3, points_.size());
    for (std::size_t i = 0; i < points_.size(); ++i) matrix.col(Eigen::Index(i)) = points_[i];
    return matrix;
  }

 private:
  int n_;
  std::vector<Eigen::Vector3d> points_;
  std::map<std::array<int, 3>, int> on_edges_;  // (corner, other corner, weight) → index
};

// Every triangle divided into n² ones.
TriangleMesh divided(const TriangleMesh& coarse, int n) {
  SharedPoints points(coarse.points, n);
  std::vector<Eigen::Vector3i> triangles;
  triangles.reserve(std::size_t(coarse.triangle_count()) * n * n);
  std::vector<int> row, above;
  for (int t = 0; t < coarse.triangle_count(); ++t) {
    for (int j = 0; j <= n; ++j) {
      above.clear();
      for (int i = 0; i + j <= n; ++i) above.push_back(points.index(coarse.triangles.col(t), i, j));
      for (int i = 0; j > 0 && i + j <= n; ++i) {
        triangles.emplace_back(row[i], row[i + 1], above[i]);
        if (i + j < n) triangles.emplace_back(row[i + 1], above[i + 1], above[i]);
      }
      std::swap(row, above);
    }
  }
  TriangleMesh fine{points.all(), Eigen::Matrix3Xi(3, triangles.size())};
  for (std::size_t t = 0; t < triangles.size(); ++t)
    fine.triangles.col(Eigen::Index(t)) = triangles[t];
  return fine;
}

}  // namespace

TriangleMesh on_sphere(const TriangleMesh& body, int n) {
  if (n < 1) throw std::invalid_argument("sphere: its edges must be divided into n >= 1 parts");
  TriangleMesh mesh = divided(body, n);
  mesh.points.colwise().normalize();
  return mesh;
}

TriangleMesh icosphere(int n) { return on_sphere(icosahedron(), n); }
TriangleMesh octasphere(int n) { return on_sphere(octahedron(), n); }

namespace {

// The same body seen from another axis of its own, a mirror again at y = 0.
TriangleMesh seen_along(TriangleMesh body, const Eigen::Vector3d& axis,
                        const Eigen::Vector3d& across) {
  Eigen::Matrix3d frame;
  frame << across.cross(axis), across, axis;
  body.points = (frame.transpose() * body.points).eval();
  return body;
}
TriangleMesh by_a_quarter(const TriangleMesh& body) {
  return seen_along(body, Eigen::Vector3d::UnitZ(), Eigen::Vector3d::UnitX());
}

}  // namespace

TriangleMesh body_with(const PointGroup& group) {
  const TriangleMesh five = icosahedron();
  const Eigen::Vector3d above = five.points.col(0), next = five.points.col(1),
                        beside = five.points.col(2);
  const TriangleMesh three = seen_along(five, (above + next + beside).normalized(),
                                        (beside - next).normalized()),
                     two = seen_along(five, (above + next).normalized(), Eigen::Vector3d::UnitY());
  std::vector<TriangleMesh> bodies{five,        three, two, by_a_quarter(five), by_a_quarter(three),
                                   octahedron()};
  constexpr int most_corners = 24;  // of S24 and D12d
  for (const int corners : {6, 5}) bodies.push_back(lantern(corners));
  for (int corners = 7; corners <= most_corners; ++corners) bodies.push_back(lantern(corners));
  for (const TriangleMesh& body : bodies)
    if (has_symmetry(body, group)) return body;
  throw std::logic_error("no body has the symmetry " + group.symbol());
}

TriangleMesh subdivided(const TriangleMesh& mesh) { return divided(mesh, 2); }

}  // namespace sbeh::meshing
