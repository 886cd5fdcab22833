// How good a curved mesh is, in numbers.
#pragma once

#include "meshing/curved_mesh.h"
#include "meshing/triangle_mesh.h"

#include <array>
#include <map>
#include <vector>

namespace sbeh::meshing {

/// Angles and edges are those of the plain triangles between the corners, in degrees and in the
/// mesh's own unit of length.
struct Quality {
  int triangles = 0;
  double area = 0, volume = 0, reduced_volume = 0;  ///< of the curved surface
  double min_angle = 0, max_angle = 0;              ///< degrees
  double edge_ratio = 0;                            ///< longest over shortest edge
  /// Extreme values of (X_1 × X_2)·n / |X_1 × X_2| of the plain triangle, n its normal: 1 for a
  /// plain one; a curved triangle that folds over has values <= 0.
  double min_jacobian = 0, max_jacobian = 0;
  int worst_triangle = 0;       ///< the one with min_jacobian
  std::map<int, int> valences;  ///< number of triangles at a vertex → how many such vertices
  int self_intersections = 0;   ///< pairs of curved triangles, each seen as its small plain ones
  std::array<int, 2> first_pair{};  ///< of them
  int euler = 0;                    ///< V − E + F, 2 for the sphere
};

/// Throws std::invalid_argument when the triangles make no oriented surface.
Quality quality_of(const CurvedMesh& mesh);

/// Smallest Jacobian of the curved triangles, as in Quality.
double min_jacobian(const CurvedMesh& mesh);

/// The small plain triangles between the nodes, order² for each curved one, in its place and order.
TriangleMesh lattice(const CurvedMesh& mesh);
/// These order² small triangles by the nodes of the curved one.
std::vector<Eigen::Vector3i> small_triangles(int order);

}  // namespace sbeh::meshing
