// What the modes of an axisymmetric state say of a small perturbation, without any run.
#pragma once

#include "axisym/modes/parity.h"
#include "axisym/stationary/stationary_case.h"

#include <optional>

namespace sbeh::studies {

/// The least stable mode of one m and parity.
struct LinearMode {
  double eigenvalue;                ///< λ of the second variation
  double rate;                      ///< σ in the linearised flow
  std::optional<double> next_rate;  ///< of the mode that decays next
  bool
      is_resolved;  ///< the signs of both agree, and λ is farther from 0 than those of rigid motions
  axisym::Parity parity;
  axisym::Field u,
      b;  ///< of the flow's mode, over the nodes of the state, as `normalise` has them (modes/mode_file.h)

  /// From when on the next mode of a perturbation is less than a hundredth of what it was beside this one; 0 where
  /// there is none.
  double settled_at() const;
  /// When all modes of a perturbation have decayed to a fiftieth of it: only noise is left. Infinite where they do not.
  double gone_at() const;
};

/// Whether a mode of m and this parity may be part of Y_lm.
inline bool is_of_harmonic(int l, int m, axisym::Parity parity) {
  return parity == axisym::Parity::none || (parity == axisym::Parity::even) == ((l - m) % 2 == 0);
}

/// That of m and the parity of Y_lm; without a parity where the state has no up-down symmetry. Empty where Newton's method
/// or the search for modes fails.
std::optional<LinearMode> linear_mode(const axisym::StationaryCase& of, const axisym::State& state,
                                      int l, int m);

}  // namespace sbeh::studies
