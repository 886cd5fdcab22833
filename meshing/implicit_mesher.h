// A first triangulation of an implicit surface. Only for this folder.
#pragma once

#include "meshing/implicit.h"
#include "meshing/triangle_mesh.h"

namespace sbeh::meshing {

/// Triangles no larger than `size` (radius of their circumspheres on the surface), outward; by
/// CGAL.
TriangleMesh triangulate(const ImplicitShape& shape, double size);

}  // namespace sbeh::meshing
