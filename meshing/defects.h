// What keeps triangles from being a closed, outward oriented surface of the topology of a sphere.
#pragma once

#include "meshing/names.h"

#include <optional>
#include <string>

namespace sbeh::meshing {

enum class DefectKind {
  empty,                ///< no points or no triangles
  not_finite,           ///< a coordinate is no number
  no_such_point,        ///< a corner beyond the points
  polygon,              ///< a face that is no triangle (of a file)
  degenerate,           ///< a triangle without area
  repeated,             ///< the same triangle twice
  unused_point,         ///< a point without triangles
  not_manifold_edge,    ///< more than two triangles at an edge
  orientation_differs,  ///< two neighbours that see each other from different sides
  open,                 ///< an edge of only one triangle
  not_manifold_point,   ///< surfaces that touch in a point
  several_pieces,       ///< not connected
  wrong_genus,          ///< a torus, …
  inward,               ///< the volume is negative
  self_intersecting,    ///< triangles pass through each other
  sharp,                ///< no smooth surface goes through the points (`require_smooth`)
};

struct Defect {
  DefectKind kind;
  std::string text;  ///< a sentence part that names the triangle, edge or point
};

/// The first defect in the order of the list above, up to `self_intersecting`; none when the mesh is what the solver needs.
std::optional<Defect> find_defect(const TriangleMesh& mesh, const Names& names);
/// With the mesh's own numbers.
std::optional<Defect> find_defect(const TriangleMesh& mesh);

}  // namespace sbeh::meshing
