// Repairs that do not change the surface which the faces were meant to be.
#pragma once

#include "meshing/polygon_mesh.h"

#include <string>
#include <vector>

namespace sbeh::meshing {

struct Repair {
  TriangleMesh mesh;
  Names names;                    ///< of its points and triangles, as those of what was repaired
  std::vector<std::string> done;  ///< what was done, in words with counts; empty: nothing was
};

/// Cuts polygons into triangles, joins points of equal coordinates and those that are near
/// (`near_points`), removes repeated triangles, unused points and the few triangles that hang on the
/// surface or lie beside it, and small closed bodies beside it, gives all triangles one orientation, outward, closes holes of at most 8
/// edges (CGAL) and turns the longest edge of flat triangles. Larger holes, handles and
/// self-intersections remain: see `find_defect`. Numbers must be finite and corners in range; throws
/// std::invalid_argument otherwise.
Repair repaired(const PolygonMesh& mesh);

/// A triangle is flat whose height over its longest edge is below this part of that edge.
inline constexpr double flat_height = 1e-4;

}  // namespace sbeh::meshing
