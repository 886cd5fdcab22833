// How fast small perturbations of a stationary state grow, by angular number m: its modes in the linearised flow.
#pragma once

#include "axisym/modes/dissipation.h"

#include <optional>
#include <vector>

namespace sbeh::axisym {

/// A mode of the flow: u(s) cos mφ along the normal and b(s) cos mφ of the order at fixed (s, φ),
/// ∫(u² + b²) cos² mφ dS = 1, the largest |u| positive.
struct GrowthMode {
  int m;
  Parity parity;
  double rate;  ///< σ: fields go like exp(σ t), > 0 where they grow
  Field u, b;   // nodes
};

/// The model's flow about a stationary state: with viscosity, friction and the relaxation of the order, area kept
/// everywhere; of Helfrich-global the L² flow. For all but SBEH `second` must be that of SSH; it must outlive this.
struct LinearFlow {
  LinearFlow(const SecondVariation& second, const model::Material& material, model::Model model);

  const SecondVariation& second;
  model::Material material;  ///< as the model has it
  bool is_along_normals;     ///< of the L² flow, which has no other dissipation
  FlowDissipation dissipation{{FlowChain(0), FlowChain(0), FlowChain(0)}};
};

/// The `count` largest rates of m and of each parity, at the most, in descending order and without rigid motions. Empty
/// where Lanczos' iteration does not settle, and where the order diffuses: of its drag they know nothing. For SSH b = 0. How far the state is from having such modes, `lowest_modes`
/// says by its rigid_residual.
std::optional<std::vector<GrowthMode>> growth_rates(const LinearFlow& flow, int m, int count);

}  // namespace sbeh::axisym
