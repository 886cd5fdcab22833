// New triangles of even size for a surface that already has some: edges are split, collapsed and
// flipped until they have the length asked for.
#pragma once

#include "meshing/smoothing.h"
#include "meshing/triangle_mesh.h"

namespace sbeh::meshing {

/// About so many nearly equilateral triangles on a smooth surface, from a closed mesh near it that
/// has the right topology; isotropic remeshing by CGAL, then `smooth`. Throws std::invalid_argument
/// when the mesh is no closed oriented surface.
TriangleMesh remeshed(const TriangleMesh& mesh, int triangles, const Projection& onto_surface,
                      double grading);

}  // namespace sbeh::meshing
