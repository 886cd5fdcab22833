// Triangles that know where they come from, while they are repaired one by one. Only for the .cpp files of this
// folder.
#pragma once

#include "meshing/polygon_mesh.h"

#include <array>
#include <string>
#include <vector>

namespace sbeh::meshing {

struct FaceSoup {
  struct Triangle {
    std::array<int, 3> corner;
    int number;  ///< of the face it comes from, −1: none
  };
  Eigen::Matrix3Xd points;
  std::vector<int> point_numbers;  ///< as Names::points
  std::vector<Triangle> triangles;
};

/// What was done to it, in words.
class RepairLog {
 public:
  /// `count` `what` (`detail`); nothing for a count of 0.
  void add(std::size_t count, const std::string& what, const std::string& detail = {});
  std::vector<std::string> done;
};

/// Polygons are cut where the triangles come out best (CGAL).
FaceSoup soup_of(const PolygonMesh& mesh, RepairLog& log);
TriangleMesh triangle_mesh(const FaceSoup& soup);
Names names_of(const FaceSoup& soup);

/// Joins near points, removes what repeats or has a corner twice.
void clean(FaceSoup& soup, RepairLog& log);
/// Removes the few triangles that hang on a surface by an edge or a point, or lie beside it.
void remove_strays(FaceSoup& soup, RepairLog& log);
/// Removes closed bodies beside the largest one that have less than a hundredth of its area.
void remove_specks(FaceSoup& soup, RepairLog& log);
/// Points without triangles.
void remove_unused_points(FaceSoup& soup, RepairLog& log);

}  // namespace sbeh::meshing
