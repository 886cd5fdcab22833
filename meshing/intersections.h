// Triangles that pass through each other or come near each other.
#pragma once

#include "meshing/triangle_mesh.h"

#include <array>
#include <vector>

namespace sbeh::meshing {

/// Pairs of triangles that meet elsewhere than in a common corner or edge, decided exactly (CGAL);
/// each pair once, smaller index first, sorted. For oriented surfaces without degenerate triangles;
/// throws std::invalid_argument when the triangles make no such surface.
std::vector<std::array<int, 2>> self_intersections(const TriangleMesh& mesh);

/// Whether two plain triangles, corners in columns, have a point in common, decided exactly (CGAL).
bool intersect(const Eigen::Matrix3d& a, const Eigen::Matrix3d& b);

/// Pairs of boxes that overlap or touch (CGAL), given by their lowest and highest corners, 3 x boxes;
/// each pair once, smaller index first, sorted.
std::vector<std::array<int, 2>> overlapping_boxes(const Eigen::Matrix3Xd& low,
                                                  const Eigen::Matrix3Xd& high);

}  // namespace sbeh::meshing
