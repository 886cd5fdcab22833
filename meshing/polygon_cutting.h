// A polygon in space becomes triangles.
#pragma once

#include <Eigen/Core>

#include <array>
#include <vector>

namespace sbeh::meshing {

/// Corners of the triangles, those of the polygon, which may be neither flat nor convex (CGAL).
std::vector<std::array<int, 3>> cut_into_triangles(const Eigen::Matrix3Xd& points,
                                                   const std::vector<int>& polygon);

}  // namespace sbeh::meshing
