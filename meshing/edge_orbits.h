// Edges that a symmetry takes to each other: what is done to one is done to all of them. Only for the .cpp files of this folder.
#pragma once

#include "meshing/half_edge_mesh.h"
#include "meshing/mesh_symmetry.h"

#include <vector>

namespace sbeh::meshing {

using SmartEdge = OpenMesh::SmartEdgeHandle;
using SmartHalfEdge = OpenMesh::SmartHalfedgeHandle;

/// A half-edge and where the symmetry takes it, each once; shorter by those that are no longer there.
std::vector<SmartHalfEdge> orbit_of(const HalfEdgeMesh& mesh, SmartHalfEdge h,
                                    const MeshSymmetry& symmetry);
/// The same of an edge, of which one of the two directions counts.
std::vector<SmartEdge> orbit_of(const HalfEdgeMesh& mesh, SmartEdge edge,
                                const MeshSymmetry& symmetry);

/// Whether no two of them belong to one triangle.
bool are_apart(const std::vector<SmartEdge>& orbit);
/// Whether all can flip at once: they are apart, no new edge is there already, and no point is left with fewer than three triangles.
bool may_flip(const HalfEdgeMesh& mesh, const std::vector<SmartEdge>& orbit);

}  // namespace sbeh::meshing
