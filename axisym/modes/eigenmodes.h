// The lowest eigenvalues of a stationary state's second variation, by angular number m.
#pragma once

#include "axisym/modes/second_variation.h"

#include <optional>
#include <vector>

namespace sbeh::axisym {

/// A mode of the second variation: u(s) cos mφ along the normal and b(s) cos mφ of the order at fixed (s, φ),
/// ∫(u² + b²) cos² mφ dS = 1, the largest |u| positive.
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

/// The lowest `count` modes of m and of each parity, or of one, at the most. Empty where Lanczos' iteration does not
/// settle. For SSH b = 0.
std::optional<ModeSpectrum> lowest_modes(const SecondVariation& second, int m, int count);
std::optional<ModeSpectrum> lowest_modes(const SecondVariation& second, int m, Parity parity,
                                         int count);

/// Those of m, at least `count` of each parity, and so many that all negative ones are among them. Empty where they are
/// not found.
std::optional<ModeSpectrum> lowest_and_negative_modes(const SecondVariation& second, int m,
                                                      int count);
std::optional<ModeSpectrum> lowest_and_negative_modes(const SecondVariation& second, int m,
                                                      Parity parity, int count);

}  // namespace sbeh::axisym
