// The eigenvalue problem of one angular number and parity: A x = λ M x, M semidefinite.
#pragma once

#include "axisym/modes/constrained_inverse.h"
#include "axisym/modes/second_variation.h"

#include <optional>
#include <vector>

namespace sbeh::axisym {

/// Motions that cost nothing and are not to be among the modes: each vector is a sum of them and of one that is 0 in
/// `held`, and they are known exactly, not by the unknowns. Modes are orthogonal to them in M, or where that does not
/// know them in their fields.
struct FreeMotions {
  std::vector<int> held;
  Eigen::MatrixXd fields;   ///< their (u, b) in the unknowns of SecondVariation, in columns
  Eigen::MatrixXd weights;  ///< M times each, in columns; none where that is 0
  Eigen::MatrixXd squares;  ///< what they are among each other in M
};

/// Of a node's N unknowns d is number node_d and the order number node_beta. Other unknowns follow from these: loads
/// act on d and on the order alone.
template <int N>
struct ModeProblem {
  int m;
  model::ChainMatrix<N> A, M;
  Eigen::MatrixXd constraints;  ///< in its columns: rows of what stays as it is
  SoftConstraint soft;          ///< to be added to A
  Eigen::MatrixXd idle;   ///< loads that move nothing, as the other unknowns stand against them
  NodeChain square;       ///< ∫(u² + b²) r ds, of the unknowns of SecondVariation
  Eigen::MatrixXd rigid;  ///< (u, b) in these, orthonormal columns: rigid motions among the modes
  FreeMotions free;       ///< or, with no equations for what is held, those left out
  double scale;           ///< of λ
};

/// u(s) cos mφ along the normal and b(s) cos mφ of the order at fixed (s, φ), over the nodes of the sector;
/// ∫(u² + b²) cos² mφ dS = 1 over the whole state, the largest |u| positive.
struct AzimuthalMode {
  double lambda;
  Field u, b;
};

struct AzimuthalModes {
  std::vector<AzimuthalMode> modes;  ///< by ascending λ, without rigid motions
  /// Largest |λ| of a rigid motion, which is 0 for the exact state; 0 where there is none, infinite where one is not
  /// found.
  double rigid_residual = 0;
};

/// The `count` lowest, at the most. Empty where Lanczos' iteration does not settle.
template <int N>
std::optional<AzimuthalModes> lowest(const ModeProblem<N>& problem, int count);

/// Solved for are the second variation's and the flow's.
inline constexpr int flow_node_size = node_unknowns + 3;
extern template std::optional<AzimuthalModes> lowest(const ModeProblem<node_unknowns>&, int);
extern template std::optional<AzimuthalModes> lowest(const ModeProblem<flow_node_size>&, int);

}  // namespace sbeh::axisym
