// From plain triangles to curved ones: numbering and placing the nodes of order 1, 2 or 3.
#pragma once

#include "meshing/curved_mesh.h"
#include "meshing/smoothing.h"
#include "meshing/triangle_mesh.h"

namespace sbeh::meshing {

/// Numbers the nodes of a closed surface of sphere topology as CurvedMesh says and puts each onto
/// the surface: the points as they are; the nodes of an edge, shared by both triangles, so that
/// they divide its image on the surface into parts of equal length; the interior node in the
/// middle. Throws std::invalid_argument for an order outside 1 … 3 and for a mesh that is not
/// closed, oriented and of the Euler characteristic 2.
CurvedMesh curved(const TriangleMesh& mesh, int order, const Projection& onto_surface);

/// The same where a place is known by its triangle and barycentric coordinates. On an edge it must
/// not depend on which of the two triangles is asked.
using Placement = std::function<Eigen::Vector3d(int triangle, const Eigen::Vector3d& barycentric)>;
CurvedMesh curved(const TriangleMesh& mesh, int order, const Placement& place);

/// The numbers alone: 3, 6 or 10 x triangles, the corners as in `mesh`. Throws as `curved` does.
Eigen::MatrixXi numbered_nodes(const TriangleMesh& mesh, int order);

/// The same surface in triangles of a higher order, up to 3.
CurvedMesh of_order(const CurvedMesh& mesh, int order);

/// The triangles between the corners.
TriangleMesh corners(const CurvedMesh& mesh);

}  // namespace sbeh::meshing
