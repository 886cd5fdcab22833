// The modes of one stationary state, of the energy and of the flow, with their errors.
#pragma once

#include "axisym/modes/second_variation.h"
#include "studies/io/columns.h"
#include "studies/modes/mode_file.h"
#include "studies/modes/modes_input.h"

#include <string>
#include <vector>

namespace sbeh::studies {

/// With the eigenfunction of its eigenvalue, ∫(u² + b²) cos² mφ dS = 1.
struct FoundMode : StateMode {
  axisym::Field energy_u, energy_b;
  /// Estimated: a sixteenth of what half as many elements give differently; `not_known` where they do not have it.
  double eigenvalue_error = not_known, rate_error = not_known;
};

struct FoundModes {
  axisym::SecondVariation second;
  std::vector<FoundMode> modes;  // by m, parity and number
  double rigid_residual = 0;     ///< largest |λ| of a rigid motion, which is 0 of the exact state
  std::vector<std::string> warnings;
};

/// The error that is promised of an eigenvalue λ or a rate, relatively to 1 + |λ|.
inline constexpr double promised_eigenvalue = 1e-6;

/// Doubles the elements, to four times as many at the most, until the errors of the first of each m and parity are as promised. Throws Interrupted, and
/// std::runtime_error where an eigenvalue is not found.
FoundModes find_modes(const ModesInput& input, const axisym::StationaryState& state);

}  // namespace sbeh::studies
