// How fast small perturbations of a rest state grow: its modes in the linearised flow; see axisym/modes/growth_rates.h.
//
// With the forms of step_functional.h, R of the dissipation and that of the Lagrangian's Hessian, u = x exp(σt) has
// −Hessian x = σ R x under Div_C u = 0, area and volume kept and rigid motions apart; what moves along the surface follows from
// the normal motion by the balance of forces there.
#pragma once

#include "surface3d/stationary/lagrangian.h"

#include <optional>
#include <vector>

namespace sbeh::surface3d {

/// A mode of the flow: u along the node normals, b of the order on nodes that move so, ∫(u² + b²) dS = 1, the largest |u| (or, where
/// that is 0, |b|) positive.
struct GrowthMode {
  double rate;  ///< σ: fields go like exp(σ t), > 0 where they grow
  Field u, b;   // nodes
  Nodes V;      ///< velocity of the material / σ
};

/// The `count` largest rates of a state at rest of SBEH or SSH, in descending order, with the material's viscosity, friction and
/// immobility. Empty where the surface is degenerate, the order diffuses, whose drag they do not know,
/// or the iteration does not settle.
std::optional<std::vector<GrowthMode>> growth_rates(const model::Material& material,
                                                    const Triangulation& mesh, model::Model model,
                                                    const StationaryState& state, int count);

}  // namespace sbeh::surface3d
