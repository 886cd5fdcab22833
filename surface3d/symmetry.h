// Surfaces with a point group, on triangles that have it.
#pragma once

#include "meshing/mesh_symmetry.h"
#include "surface3d/surface.h"

#include <optional>

namespace sbeh::surface3d {

/// See meshing/mesh_symmetry.h: of triangles that were made symmetric, wherever their surface has gone since.
std::optional<meshing::MeshSymmetry> symmetry_of(const Triangulation& mesh, const State& state,
                                                 const meshing::PointGroup& group);
/// Throws std::invalid_argument unless the group takes the surface to itself.
meshing::MeshSymmetry required_symmetry(const Triangulation& mesh, const State& state,
                                        const meshing::PointGroup& group);

/// The part of a group of the triangles that the state has, positions (in radii) and order to 1e-6.
meshing::PointGroup kept_symmetry(const Triangulation& mesh, const State& state,
                                  const meshing::PointGroup& group);

/// What of positions and order the group leaves as it is: the mean over its operations.
State symmetric_part(const meshing::MeshSymmetry& symmetry, const State& state);

/// The largest distance of a node, along its normal, from the symmetric part of the surface, in radii √(A/4π).
double asymmetry(const Triangulation& mesh, const State& state,
                 const meshing::MeshSymmetry& symmetry);

}  // namespace sbeh::surface3d
