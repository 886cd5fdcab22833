// Which triangles see their neighbours from the other side.
#pragma once

#include "meshing/triangle_mesh.h"

#include <vector>

namespace sbeh::meshing {

/// The fewest triangles to turn so that neighbours, which are two at an edge, agree; of each connected piece.
std::vector<int> turned_triangles(const TriangleMesh& mesh);

}  // namespace sbeh::meshing
