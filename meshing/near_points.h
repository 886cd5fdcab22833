// Points of a mesh that were meant to be one.
#pragma once

#include "meshing/triangle_mesh.h"

#include <optional>
#include <vector>

namespace sbeh::meshing {

/// Points nearer to each other than this part of the edges around them were meant to be one.
inline constexpr double near_part_of_an_edge = 1e-3;

struct NearPoints {
  std::vector<int> first;  ///< of each point: the lowest of those that are one with it
  int joined = 0;          ///< points that have a lower one
  double farthest = 0;     ///< how far one of them is from its first

  /// Nearest pair that differs: two points and their distance.
  struct Pair {
    int a, b;
    double distance;
  };
  std::optional<Pair> example = {};
};

/// Points of equal coordinates; and of those at open edges, or joined by an edge, those that are near. Points
/// without triangles stay.
NearPoints near_points(const TriangleMesh& mesh);

/// The same for any points: `scale` > 0 is the length of the edges around each, and only points that are `loose`
/// are joined unless their coordinates are equal.
NearPoints near_points(const Eigen::Matrix3Xd& points, const Eigen::VectorXd& scale,
                       const std::vector<bool>& loose);

/// At which points there is an edge of only one triangle.
std::vector<bool> points_at_open_edges(const TriangleMesh& mesh);

/// Of each point: the shortest of the longest edges of its triangles; 0 without triangles.
Eigen::VectorXd edge_scale(const TriangleMesh& mesh);

}  // namespace sbeh::meshing
