// The lowest eigenvalues of a stationary state's second variation, by angular number m.
#pragma once

#include "axisym/modes/mode_problem.h"

#include <array>
#include <optional>
#include <vector>

namespace sbeh::axisym {

/// A mode of the second variation; its fields are normalised as those of AzimuthalMode.
struct Eigenmode {
  int m;
  Parity parity;
  double eigenvalue;  ///< λ: δ²F = λ ∫(u² + b²) cos² mφ dS, area and volume kept
  Field u, b;         // nodes
};

/// The lowest modes of one m.
struct ModeSpectrum {
  std::vector<Eigenmode> modes;  ///< ascending, without rigid motions
  /// Largest |λ| of a rigid motion, which is 0 for the exact state; 0 where m has none, infinite where one is not
  /// found.
  double rigid_residual = 0;
};

/// The lowest `count` modes of m and of each parity, at the most. Empty where Lanczos' iteration does not settle.
/// For SSH b = 0.
std::optional<ModeSpectrum> lowest_modes(const SecondVariation& second, int m, int count);

}  // namespace sbeh::axisym
