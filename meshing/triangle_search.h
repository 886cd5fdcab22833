// Searches among plain triangles: which is nearest to a point, which pass through each other or come near each
// other (CGAL).
#pragma once

#include "meshing/triangle_mesh.h"

#include <array>
#include <functional>
#include <vector>

namespace sbeh::meshing {

/// A place on a plain triangle.
struct TrianglePlace {
  int triangle;
  Eigen::Vector3d barycentric;  ///< >= 0, sum 1
};
/// The place nearest to a point, in triangles prepared for searching; copies share the tree.
using NearestTriangle = std::function<TrianglePlace(const Eigen::Vector3d&)>;
NearestTriangle nearest_triangle(const TriangleMesh& mesh);

/// Pairs of triangles that meet elsewhere than in a common corner or edge, decided exactly;
/// each pair once, smaller index first, sorted. For oriented surfaces without degenerate triangles;
/// throws std::invalid_argument when the triangles make no such surface.
std::vector<std::array<int, 2>> self_intersections(const TriangleMesh& mesh);

/// Whether two plain triangles, corners in columns, have a point in common, decided exactly.
bool intersect(const Eigen::Matrix3d& a, const Eigen::Matrix3d& b);

/// Pairs of boxes that overlap or touch, given by their lowest and highest corners, 3 x boxes;
/// each pair once, smaller index first, sorted.
std::vector<std::array<int, 2>> overlapping_boxes(const Eigen::Matrix3Xd& low,
                                                  const Eigen::Matrix3Xd& high);

}  // namespace sbeh::meshing
