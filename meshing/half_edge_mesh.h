// The half-edge mesh on which triangles are flipped and nodes are numbered. Only for the .cpp files
// of this folder: OpenMesh stays behind TriangleMesh and CurvedMesh.
#pragma once

#include "meshing/triangle_mesh.h"

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>

namespace sbeh::meshing {

struct HalfEdgeTraits : OpenMesh::DefaultTraits {
  using Point = OpenMesh::Vec3d;
  using Normal = OpenMesh::Vec3d;
};
using HalfEdgeMesh = OpenMesh::TriMesh_ArrayKernelT<HalfEdgeTraits>;

/// Same points, same triangles, same indices. Throws std::invalid_argument naming the triangle
/// which cannot be added: an edge would belong to more than two, or to two of opposite orientation.
HalfEdgeMesh half_edge_mesh(const TriangleMesh& mesh);

/// The way back.
TriangleMesh triangle_mesh(const HalfEdgeMesh& mesh);

inline Eigen::Map<const Eigen::Vector3d> point(const HalfEdgeMesh& mesh,
                                               OpenMesh::VertexHandle vertex) {
  return Eigen::Map<const Eigen::Vector3d>(mesh.point(vertex).data());
}

inline void set_point(HalfEdgeMesh& mesh, OpenMesh::VertexHandle vertex, const Eigen::Vector3d& x) {
  mesh.set_point(vertex, {x[0], x[1], x[2]});
}

}  // namespace sbeh::meshing
