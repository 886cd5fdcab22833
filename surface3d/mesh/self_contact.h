// Whether a surface comes near itself.
#pragma once

#include "surface3d/surface.h"

#include <array>
#include <vector>

namespace sbeh::surface3d {

/// Two triangles that are far apart along the surface and near in space.
struct Contact {
  std::array<int, 2> triangles;  ///< the smaller number first
  Eigen::Vector3d where;         ///< the middle between the nearest places
  double distance;               ///< 0 where they intersect
  double relative;               ///< distance over the side of an equilateral triangle with the
                                 ///< smaller area of the two
};

/// Sheets that are as near as the nodes of a triangle are nearly in contact.
inline constexpr double contact_distance = 1. / 3;

/// All pairs with `relative` below the limit, nearest first. Far apart along the surface means: no
/// triangle has a corner in common with both. Distances are those from the nodes of one to the small
/// plain triangles between the nodes of the other, so that they are exact for nodes that face each
/// other and wrong by O(h²) else; intersections are decided exactly on the small triangles (CGAL).
/// Intersections count at any limit. What happens between neighbours is seen by mesh_quality. Throws
/// std::invalid_argument unless 0 < limit <= 1/2: farther away begin the neighbours of neighbours.
std::vector<Contact> self_contacts(const Triangulation& mesh, const Nodes& X,
                                   double limit = contact_distance);

}  // namespace sbeh::surface3d
