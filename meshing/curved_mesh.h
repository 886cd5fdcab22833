// A closed surface of curved Lagrange triangles: what a mesh is made into and what the 3D solver moves.
#pragma once

#include <Eigen/Core>

namespace sbeh::meshing {

/// Closed, oriented surface of the topology of a sphere, isoparametric triangles of one order.
///
/// Numbering of the nodes: first the vertices, then order − 1 consecutive nodes for each edge, then
/// the interior nodes of each triangle. A triangle lists its nodes in the order of
/// model::TriangleElement (and of VTK), its corners counter-clockwise seen from outside.
/// V + F − E = 2 with V vertices, F triangles, E = 3F/2 edges, so that V = F/2 + 2.
struct CurvedMesh {
  int order = 3;              ///< 1, 2 or 3
  Eigen::MatrixXi triangles;  ///< 3, 6 or 10 nodes x triangles
  Eigen::Matrix3Xd nodes;     ///< 3 x nodes

  int triangle_count() const { return int(triangles.cols()); }
  int vertex_count() const { return triangle_count() / 2 + 2; }
  int edge_count() const { return 3 * triangle_count() / 2; }
  int node_count() const { return int(nodes.cols()); }
};

}  // namespace sbeh::meshing
