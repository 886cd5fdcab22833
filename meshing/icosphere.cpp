#include "meshing/icosphere.h"

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

TriangleMesh icosphere(int n) {
  if (n < 1) throw std::invalid_argument("icosphere: n must be >= 1");
  TriangleMesh mesh = divided(icosahedron(), n);
  mesh.points.colwise().normalize();
  return mesh;
}

TriangleMesh octasphere(int n) {
  if (n < 1) throw std::invalid_argument("octasphere: n must be >= 1");
  TriangleMesh mesh = divided(octahedron(), n);
  mesh.points.colwise().normalize();
  return mesh;
}

TriangleMesh subdivided(const TriangleMesh& mesh) { return divided(mesh, 2); }

}  // namespace sbeh::meshing
