// The lowest eigenvalues of a stationary state's second variation, by angular number m.
#pragma once

#include "axisym/modes/second_variation.h"

#include <array>
#include <optional>
#include <vector>

namespace sbeh::axisym {

/// Whether a mode of an up-down symmetric state goes into itself upside down (even), or into its negative.
enum class Parity { even, odd, none };
constexpr auto names(Parity) { return std::array{"even", "odd", "none"}; }

/// u(s) cos mφ along the normal and b(s) cos mφ of the order at fixed (s, φ), ∫(u² + b²) cos² mφ dS = 1.
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
