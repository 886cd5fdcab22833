// Meshes that turns and mirrors leave as they are.
#pragma once

#include "meshing/curved_mesh.h"
#include "meshing/point_group.h"
#include "meshing/smoothing.h"
#include "meshing/triangle_mesh.h"

#include <optional>
#include <vector>

namespace sbeh::meshing {

/// How a group permutes the nodes of a mesh.
struct MeshSymmetry {
  std::vector<Operation> operations;  ///< a group, the identity first
  Eigen::MatrixXi image;  ///< nodes x operations: which node is where each one is taken to

  /// The part of positions or vectors at the nodes that the group leaves as it is, 3 x nodes.
  Eigen::Matrix3Xd symmetric_part(const Eigen::Matrix3Xd& vectors) const;
  /// The same of a value at each node.
  Eigen::VectorXd symmetric_part(const Eigen::VectorXd& values) const;
  /// The largest distance between where a node is taken to and its image.
  double misfit(const Eigen::Matrix3Xd& nodes) const;
};

/// For each operation the way to take triangles to triangles, neighbours to neighbours, that fits it best: where the nodes are counts for
/// the choice alone, so that a mesh that was made symmetric is known again after its surface has lost that. Empty where two
/// operations have the same, or one has none.
std::optional<MeshSymmetry> symmetry_of(const CurvedMesh& mesh,
                                        const std::vector<Operation>& operations);

/// The same of a mesh that is symmetric, up to 1e-6 of its largest radius. Throws std::invalid_argument for any other.
MeshSymmetry required_symmetry(const CurvedMesh& mesh, const PointGroup& group);
/// Of triangles that have it, wherever their points are. Throws std::invalid_argument for any other.
MeshSymmetry symmetry_of_triangles(const TriangleMesh& mesh, const PointGroup& group);

/// Curved triangles on a symmetric surface, between corners that have its symmetry, whose other nodes are placed with an error that has not:
/// each goes to the mean of where its images say that it is, and onto the surface. Throws std::invalid_argument for other triangles.
void symmetrise(CurvedMesh& mesh, const PointGroup& group, const Projection& onto_surface);

/// Whether the mesh is symmetric in that sense.
bool has_symmetry(const TriangleMesh& mesh, const PointGroup& group);

}  // namespace sbeh::meshing
