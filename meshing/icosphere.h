// The unit sphere made of the faces of a regular body: where meshes of sphere topology begin.
#pragma once

#include "meshing/point_group.h"
#include "meshing/triangle_mesh.h"

namespace sbeh::meshing {

/// Icosahedron whose edges are divided into n >= 1 parts, 20 n² triangles, points on the unit
/// sphere. Two opposite vertices lie on the z axis, which is so a five-fold axis of the mesh: no
/// two-fold one, which would feed the two-fold instabilities of shapes of revolution about z.
TriangleMesh icosphere(int n);

/// Octahedron whose edges are divided into n >= 1 parts, 8 n² triangles, points on the unit sphere. None of them crosses a
/// plane of coordinates, so that their images stay simple when the sphere is stretched along the axes.
TriangleMesh octasphere(int n);

/// A body with this symmetry, corners on the unit sphere: the icosahedron or the octahedron, turned as need be, or one with
/// rings of as many corners as the axis wants, though no fewer than five.
TriangleMesh body_with(const PointGroup& group);
/// A body whose edges are divided into n >= 1 parts, points on the unit sphere.
TriangleMesh on_sphere(const TriangleMesh& body, int n);

/// Every triangle divided into four by the midpoints of its edges. The old points keep their
/// indices.
TriangleMesh subdivided(const TriangleMesh& mesh);

}  // namespace sbeh::meshing
