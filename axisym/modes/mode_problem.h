// The eigenvalue problem of one angular number: A x = λ M x, M semidefinite.
#pragma once

#include "axisym/modes/second_variation.h"

#include <optional>
#include <vector>

namespace sbeh::axisym {

/// Whether a mode of an up-down symmetric state goes into itself upside down (even), or into its negative.
enum class Parity { even, odd, none };
constexpr auto names(Parity) { return std::array{"even", "odd", "none"}; }

/// A motion x that costs nothing, A x = 0, and is not to be among the modes, so that these have mode · M x = 0; and an
/// unknown that it changes. Where M x = 0 the modes are orthogonal to it in their fields.
struct FreeMotion {
  Eigen::VectorXd x;
  Eigen::VectorXd weight;  ///< M x as it is for the exact motion; empty: 0
  int held;
};

/// Both matrices go node by node; of a node's unknowns d is number node_d and the order number node_beta. Other
/// unknowns follow from these: loads act on d and on the order alone.
struct ModeProblem {
  int m;
  int node_size;  ///< unknowns of a node
  model::BandMatrix A, M;
  Eigen::MatrixXd constraints;  ///< in its columns: rows of what stays as it is
  Eigen::MatrixXd idle;      ///< loads that move nothing, as the other unknowns stand against them
  model::BandMatrix square;  ///< ∫(u² + b²) r ds, of the unknowns of SecondVariation
  std::vector<Eigen::VectorXd>
      rigid;                     ///< (u, b) in these, orthonormal: rigid motions among the modes
  std::vector<FreeMotion> free;  ///< or, with no equations for what is held, those left out
  double scale;                  ///< of λ
};

/// u(s) cos mφ along the normal and b(s) cos mφ of the order at fixed (s, φ), ∫(u² + b²) cos² mφ dS = 1, the largest
/// |u| positive.
struct AzimuthalMode {
  Parity parity;
  double lambda;
  Field u, b;  // nodes
};

struct AzimuthalModes {
  std::vector<AzimuthalMode> modes;  ///< by ascending λ, without rigid motions
  /// Largest |λ| of a rigid motion, which is 0 for the exact state; 0 where there is none, infinite where one is not
  /// found.
  double rigid_residual = 0;
};

/// The `count` lowest of each parity, at the most. Empty where Lanczos' iteration does not settle. `is_symmetric`:
/// whether the state has a parity.
std::optional<AzimuthalModes> lowest(const ModeProblem& problem, bool is_symmetric, int count);

}  // namespace sbeh::axisym
