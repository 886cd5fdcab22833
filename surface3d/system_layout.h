// Which unknowns the systems of the coupled step have, in which order, and which of them meet.
#pragma once

#include "model/material.h"
#include "surface3d/surface.h"

namespace sbeh::surface3d {

/// Of the flow: V, p, H, the displacement Y where the scheme has it there, and the multipliers: λ and
/// what else there is. Under a global area constraint the speeds v along the node normals stand in the
/// place of V, and p, a number, is the last of the multipliers.
struct FlowLayout {
  SparsePattern pattern;
  int p, H, Y, lambda;  ///< where these begin
};
FlowLayout flow_layout(const Triangulation& mesh, model::AreaConstraint area, bool has_displacement,
                       int multipliers);
/// The tangential displacements, two at each node.
SparsePattern motion_pattern(const Triangulation& mesh);

/// The system of the flow on a triangle, before V is restricted to the node normals. Vectors stand by
/// components, in the global systems by nodes. The rows of the test functions W, q, G, Z are the columns
/// of V, p, H, Y; Y and Z are there where the scheme has them, and then the multipliers follow.
struct FlowPiece {
  static constexpr int V = 0, p = 30, H = 36, Y = 46;
  static constexpr int W = V, q = p, G = H, Z = Y;
  Eigen::MatrixXd matrix;
  Eigen::VectorXd rhs;
  auto block(int test, int unknown) { return matrix.block<10, 10>(test, unknown); }
};

}  // namespace sbeh::surface3d
