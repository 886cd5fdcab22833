// Repairs that do not change the surface which the triangles were meant to be.
#pragma once

#include "meshing/triangle_mesh.h"

#include <string>
#include <vector>

namespace sbeh::meshing {

struct Repair {
  TriangleMesh mesh;
  std::vector<std::string> done;  ///< what was done, in words with counts; empty: nothing was
};

/// Merges points of equal coordinates, removes triangles without area, repeated triangles and
/// unused points, gives all triangles one orientation, outward, and closes holes of at most 8
/// edges (CGAL). Larger holes, handles and self-intersections remain: see `find_defect`. Numbers
/// must be finite and corners in range; throws std::invalid_argument otherwise.
Repair repaired(const TriangleMesh& mesh);

}  // namespace sbeh::meshing
