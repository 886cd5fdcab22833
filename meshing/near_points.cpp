#include "meshing/near_points.h"

#include "meshing/triangle_search.h"

#include <boost/pending/disjoint_sets.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace sbeh::meshing {

namespace {

using Pairs = std::vector<std::array<int, 2>>;
using Edge = std::array<int, 2>;

Edge edge(int a, int b) { return {std::min(a, b), std::max(a, b)}; }

// Each point with the first one of the same coordinates.
Pairs equal_points(const Eigen::Matrix3Xd& points) {
  std::map<std::array<double, 3>, int> first;
  Pairs pairs;
  for (int i = 0; i < points.cols(); ++i) {
    const auto [place, is_new] = first.try_emplace({points(0, i), points(1, i), points(2, i)}, i);
    if (!is_new) pairs.push_back({place->second, i});
  }
  return pairs;
}

Pairs near_pairs(const Eigen::Matrix3Xd& points, const Eigen::VectorXd& scale,
                 const std::vector<bool>& loose) {
  std::vector<int> those;
  for (int i = 0; i < points.cols(); ++i)
    if (loose[std::size_t(i)]) those.push_back(i);
  const Eigen::VectorXd reach = near_part_of_an_edge * scale(those);
  const Eigen::Matrix3Xd x = points(Eigen::all, those),
                         half = reach.transpose().replicate<3, 1>() / 2;
  Pairs pairs;
  for (const auto& [a, b] : overlapping_boxes(x - half, x + half))
    if ((x.col(a) - x.col(b)).norm() < std::min(reach[a], reach[b]))
      pairs.push_back({those[std::size_t(a)], those[std::size_t(b)]});
  return pairs;
}

NearPoints joined(const Eigen::Matrix3Xd& points, const Pairs& pairs) {
  const auto count = std::size_t(points.cols());
  boost::disjoint_sets_with_storage<> sets(count);
  NearPoints near;
  for (const auto& [a, b] : pairs) {
    sets.union_set(std::size_t(a), std::size_t(b));
    const double d = (points.col(a) - points.col(b)).norm();
    if (d > 0 && (!near.example || d < near.example->distance)) near.example = {a, b, d};
  }
  std::vector<int> lowest(count, -1);  // of each set, by its representative
  for (std::size_t i = 0; i < count; ++i) {
    int& first = lowest[sets.find_set(i)];
    if (first < 0) first = int(i);
    near.first.push_back(first);
    if (first == int(i)) continue;
    ++near.joined;
    near.farthest = std::max(near.farthest, (points.col(first) - points.col(int(i))).norm());
  }
  return near;
}

}  // namespace

std::vector<bool> points_at_open_edges(const TriangleMesh& mesh) {
  std::map<Edge, int> triangles;
  for (const auto c : mesh.triangles.colwise())
    for (int k = 0; k < 3; ++k) ++triangles[edge(c[k], c[(k + 1) % 3])];
  std::vector<bool> open(std::size_t(mesh.point_count()), false);
  for (const auto& [ends, count] : triangles)
    if (count == 1)
      for (const int point : ends) open[std::size_t(point)] = true;
  return open;
}

Eigen::VectorXd edge_scale(const TriangleMesh& mesh) {
  Eigen::VectorXd scale = Eigen::VectorXd::Zero(mesh.point_count());
  for (const auto c : mesh.triangles.colwise()) {
    double longest = 0;
    for (int k = 0; k < 3; ++k)
      longest = std::max(longest, (mesh.points.col(c[k]) - mesh.points.col(c[(k + 1) % 3])).norm());
    if (longest == 0) continue;
    for (const int corner : c)
      scale[corner] = scale[corner] > 0 ? std::min(scale[corner], longest) : longest;
  }
  return scale;
}

NearPoints near_points(const Eigen::Matrix3Xd& points, const Eigen::VectorXd& scale,
                       const std::vector<bool>& loose) {
  Pairs pairs = equal_points(points);
  const Pairs near = near_pairs(points, scale, loose);
  pairs.insert(pairs.end(), near.begin(), near.end());
  return joined(points, pairs);
}

NearPoints near_points(const TriangleMesh& mesh) {
  // Equal points first: what is loose is told by the edges that are left.
  Pairs pairs = equal_points(mesh.points);
  const std::vector<int> first = joined(mesh.points, pairs).first;
  TriangleMesh merged = mesh;
  for (int& corner : merged.triangles.reshaped()) corner = first[std::size_t(corner)];
  const Eigen::VectorXd scale = edge_scale(merged);
  const Pairs near = near_pairs(mesh.points, scale, points_at_open_edges(merged));
  pairs.insert(pairs.end(), near.begin(), near.end());
  for (const auto c : merged.triangles.colwise())
    for (int k = 0; k < 3; ++k) {
      const int a = c[k], b = c[(k + 1) % 3];
      if ((mesh.points.col(a) - mesh.points.col(b)).norm()
          < near_part_of_an_edge * std::min(scale[a], scale[b]))
        pairs.push_back({a, b});
    }
  return joined(mesh.points, pairs);
}

}  // namespace sbeh::meshing
