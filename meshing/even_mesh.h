// Even curved triangles on a smooth surface that is an image of the sphere.
#pragma once

#include "meshing/curved_mesh.h"
#include "meshing/resolution.h"
#include "meshing/smoothing.h"

namespace sbeh::meshing {

/// The icosphere taken to the surface by `from_sphere` (unit vectors → points) and smoothed there
/// with `onto_surface`, from coarse to fine. Where that leaves angles below 40° or strongly
/// distorted curved triangles, other smoothing and new triangles are tried, and the best is taken.
/// Throws std::invalid_argument when even that has triangles which fold over: the surface bends
/// too sharply for so few.
CurvedMesh even_mesh(const Resolution& resolution, const Projection& from_sphere,
                     const Projection& onto_surface);

}  // namespace sbeh::meshing
