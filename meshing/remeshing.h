// New triangles for a surface that already has some: edges are split, collapsed and flipped until they have
// the length asked for.
#pragma once

#include "meshing/smoothing.h"
#include "meshing/triangle_mesh.h"

namespace sbeh::meshing {

/// About so many nearly equilateral triangles on a smooth surface, from a closed mesh near it that
/// has the right topology; isotropic remeshing by CGAL, then `smooth`. Throws std::invalid_argument
/// when the mesh is no closed oriented surface, and when so many triangles are too large to go round it.
TriangleMesh remeshed(const TriangleMesh& mesh, int triangles, const Projection& onto_surface,
                      double grading);

/// Wanted edge lengths at points of the surface, in the mesh's unit of length.
using SizeField = std::function<double(const Eigen::Vector3d&)>;

/// Nearly equilateral triangles with edges of these lengths on a smooth surface, from a closed mesh on
/// it. Edges longer than 4/3 of the wanted length are split, those shorter than 4/5 collapse, edges
/// flip towards six triangles at each point, points move along the surface; at last `smooth`. (CGAL 5.5
/// remeshes to one length only: `remeshed` is for that, and for meshes that are poor to start from.)
/// The size should not change by more than about a third from neighbour to neighbour. Throws
/// std::invalid_argument when the mesh is no closed oriented surface, or has not the symmetry, which it keeps.
TriangleMesh graded(const TriangleMesh& mesh, const SizeField& size, const Projection& onto_surface,
                    const PointGroup& symmetry = {});

}  // namespace sbeh::meshing
