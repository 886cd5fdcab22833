// Where another branch crosses: the classical stomatocytes leave the oblates in a pitchfork.
#pragma once

#include "axisym/stationary/arclength.h"

namespace sbeh::axisym {

/// The direction of shape and order in which the energy curves least, up-down antisymmetric, with
/// ∫(d² + β²) dS = 1, and that curvature of the energy.
struct SoftMode {
  double eigenvalue;
  Increment direction;
};

/// The softest antisymmetric mode of an up-down symmetric state by inverse iteration, area and volume
/// kept. Empty when the iteration does not settle.
std::optional<SoftMode> antisymmetric_mode(const model::Material& material, model::Model model,
                                           const StationaryState& s);

/// A pitchfork on a line: the state there and the direction of the crossing branch.
struct Pitchfork {
  PathState state;  ///< its tangent is that of the crossing branch
};

/// Follows the symmetric branch of `from` along the line until the antisymmetric mode's eigenvalue
/// changes sign, and locates its zero to about 1e-10 in μ; the
/// state is the one last solved for, within 1e-6 of it. Empty when it does not on 0 <= μ <= 1.
std::optional<Pitchfork> find_pitchfork(const model::Material& material, model::Model model,
                                        const BranchState& from, PlanePoint to,
                                        const Numerics& numerics);

}  // namespace sbeh::axisym
