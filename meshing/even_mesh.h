// Even curved triangles on a smooth surface that is an image of the sphere.
#pragma once

#include "meshing/curved_mesh.h"
#include "meshing/resolution.h"
#include "meshing/smoothing.h"

#include <optional>

namespace sbeh::meshing {

/// The icosphere taken to the surface by `from_sphere` (unit vectors → points) and smoothed there
/// with `onto_surface`, from coarse to fine. Where that leaves angles below 40° or strongly
/// distorted curved triangles, other smoothing and new triangles are tried, and the best is taken.
/// Empty when even that has triangles which fold over: the surface bends too sharply for so few.
std::optional<CurvedMesh> even_mesh_if_any(const Resolution& resolution,
                                           const Projection& from_sphere,
                                           const Projection& onto_surface);

/// Throws std::invalid_argument where there is none.
CurvedMesh even_mesh(const Resolution& resolution, const Projection& from_sphere,
                     const Projection& onto_surface);

/// Says that the triangles are too few.
[[noreturn]] void refuse_as_too_sharp(const Resolution& resolution);

}  // namespace sbeh::meshing
