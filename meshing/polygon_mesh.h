// Points and the polygons between them: what a file of plain faces has.
#pragma once

#include "meshing/names.h"

#include <vector>

namespace sbeh::meshing {

/// At least three corners each, whose numbers are in range; the names are those of points and faces.
struct PolygonMesh {
  Eigen::Matrix3Xd points;              ///< 3 x points
  std::vector<std::vector<int>> faces;  ///< indices of points
  Names names = {};

  int point_count() const { return int(points.cols()); }
  int face_count() const { return int(faces.size()); }
};

/// The same triangles as faces, with their own numbers.
PolygonMesh polygon_mesh(const TriangleMesh& mesh);

/// Index of the first face that is no triangle; −1: there is none.
int first_polygon(const PolygonMesh& mesh);

/// All faces must be triangles.
TriangleMesh triangle_mesh(const PolygonMesh& mesh);

}  // namespace sbeh::meshing
