// The unit sphere made of the faces of a regular body: where meshes of sphere topology begin.
#pragma once

#include "meshing/triangle_mesh.h"

namespace sbeh::meshing {

/// Icosahedron whose edges are divided into n >= 1 parts, 20 n² triangles, points on the unit
/// sphere. Two opposite vertices lie on the z axis, which is so a five-fold axis of the mesh: no
/// two-fold one, which would feed the two-fold instabilities of shapes of revolution about z.
TriangleMesh icosphere(int n);

/// Octahedron whose edges are divided into n >= 1 parts, 8 n² triangles, points on the unit sphere. None of them crosses a
/// plane of coordinates, so that their images stay simple when the sphere is stretched along the axes.
TriangleMesh octasphere(int n);

/// Every triangle divided into four by the midpoints of its edges. The old points keep their
/// indices.
TriangleMesh subdivided(const TriangleMesh& mesh);

}  // namespace sbeh::meshing
