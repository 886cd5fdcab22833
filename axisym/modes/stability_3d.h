// Stability of a stationary state among all shapes, not only those with an axis.
#pragma once

#include "axisym/modes/eigenmodes.h"

#include <limits>

namespace sbeh::axisym {

/// Eigenvalues and rates are given up to this m at the most.
inline constexpr int most_modes = 6;

/// What the modes m = 0 … of a state say of it.
struct Stability3d {
  /// The lowest of each m, rigid motions left out; nan where it was not computed.
  std::array<double, most_modes + 1> eigenvalue = all_unknown();
  /// Of the model's flow the largest of each m, likewise.
  std::array<double, most_modes + 1> rate = all_unknown();
  double rigid_residual = std::numeric_limits<double>::quiet_NaN();  ///< see ModeSpectrum
  /// Of how many independent directions the energy falls in; each m ≥ 1 counts twice. Empty where an eigenvalue is
  /// nearer to zero than what rigid motions leave, so that its sign is not known.
  std::optional<int> negative_directions;
  std::vector<int> unstable;  ///< the m with negative eigenvalues, those above the largest too

 private:
  static constexpr std::array<double, most_modes + 1> all_unknown() {
    std::array<double, most_modes + 1> a{};
    a.fill(std::numeric_limits<double>::quiet_NaN());
    return a;
  }
};

/// The modes m = 0 … largest_m of a stationary state, and of higher m those with negative eigenvalues, up to an m that
/// has none: what comes after grows like m⁴ and is taken to be positive. The material is that of the state's place. Empty where they are not found.
std::optional<Stability3d> stability_3d(const model::Material& material, model::Model model,
                                        const StationaryState& state, int largest_m);

}  // namespace sbeh::axisym
