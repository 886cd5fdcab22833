// Even plain triangles on a smooth surface that is an image of the sphere.
#pragma once

#include "meshing/resolution.h"
#include "meshing/smoothing.h"

namespace sbeh::meshing {

/// The icosphere taken to the surface by `from_sphere` (unit vectors → points) and smoothed there
/// with `onto_surface`, from coarse to fine; remeshed if that leaves angles below 40°.
TriangleMesh even_mesh(const Resolution& resolution, const Projection& from_sphere,
                       const Projection& onto_surface);

}  // namespace sbeh::meshing
