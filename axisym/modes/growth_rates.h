// How fast small perturbations of a stationary state grow, by angular number m: its modes in the linearised flow.
#pragma once

#include "axisym/modes/mode_problem.h"

namespace sbeh::axisym {

/// A mode of the flow; its fields are normalised as those of AzimuthalMode.
struct GrowthMode {
  int m;
  Parity parity;
  double rate;  ///< σ: fields go like exp(σ t), > 0 where they grow
  Field u, b;   // nodes
};

/// The `count` largest rates of m and of each parity, at the most, in descending order and without rigid motions, of
/// the model's flow: with viscosity, friction and the relaxation of the order, area kept everywhere; of
/// Helfrich-global the L² flow. Empty where Lanczos' iteration does not settle. For all but SBEH `second` must be that
/// of SSH, and b = 0. How far the state is from having such modes, `lowest_modes` says by its rigid_residual.
std::optional<std::vector<GrowthMode>> growth_rates(const SecondVariation& second,
                                                    const model::Material& material,
                                                    model::Model model, int m, int count);

}  // namespace sbeh::axisym
