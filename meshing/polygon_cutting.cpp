#include "meshing/polygon_cutting.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/triangulate_hole.h>
#include <CGAL/utility.h>

namespace sbeh::meshing {

std::vector<std::array<int, 3>> cut_into_triangles(const Eigen::Matrix3Xd& points,
                                                   const std::vector<int>& polygon) {
  std::vector<std::array<int, 3>> triangles;
  if (polygon.size() > 3) {
    std::vector<CGAL::Epick::Point_3> corners;
    corners.reserve(polygon.size());
    for (const int i : polygon) corners.emplace_back(points(0, i), points(1, i), points(2, i));
    std::vector<CGAL::Triple<int, int, int>> found;
    CGAL::Polygon_mesh_processing::triangulate_hole_polyline(corners, std::back_inserter(found));
    for (const auto& t : found)
      triangles.push_back({polygon[std::size_t(t.first)], polygon[std::size_t(t.second)],
                           polygon[std::size_t(t.third)]});
  }
  // A triangle; or corners that CGAL finds no triangles for, such as those of a polygon without area.
  if (triangles.empty())
    for (std::size_t k = 1; k + 1 < polygon.size(); ++k)
      triangles.push_back({polygon[0], polygon[k], polygon[k + 1]});
  return triangles;
}

}  // namespace sbeh::meshing
