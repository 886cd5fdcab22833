// Triangles that pass through each other.
#pragma once

#include "meshing/triangle_mesh.h"

#include <array>
#include <vector>

namespace sbeh::meshing {

/// Pairs of triangles that meet elsewhere than in a common corner or edge, decided exactly (CGAL);
/// each pair once, smaller index first, sorted. For oriented surfaces without degenerate triangles;
/// throws std::invalid_argument when the triangles make no such surface.
std::vector<std::array<int, 2>> self_intersections(const TriangleMesh& mesh);

}  // namespace sbeh::meshing
