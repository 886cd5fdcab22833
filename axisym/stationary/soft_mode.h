// The mode by which an up-down symmetric state loses its symmetry.
#pragma once

#include "axisym/stationary/arclength.h"

#include <optional>

namespace sbeh::axisym {

/// The direction of shape and order in which the energy curves least, up-down antisymmetric, with
/// ∫(d² + β²) dS = 1, and that curvature of the energy.
struct SoftMode {
  double eigenvalue;
  Increment direction;
};

/// Of an up-down symmetric state the antisymmetric mode whose eigenvalue is nearest to zero, by inverse iteration, area and
/// volume kept. Empty when the iteration does not settle.
std::optional<SoftMode> antisymmetric_mode(const model::Material& material, model::Model model,
                                           const StationaryState& state);

/// The state on the line, with the mode's direction as its tangent: where the eigenvalue is zero a branch begins that
/// leaves along it.
PathState along_mode(const LineState& state, const SoftMode& mode);

}  // namespace sbeh::axisym
