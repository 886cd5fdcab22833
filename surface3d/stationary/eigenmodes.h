// The lowest eigenpairs of a stationary state's second variation among all perturbations that keep area and volume,
// rigid motions apart; see axisym/modes for those of surfaces of revolution.
#pragma once

#include "surface3d/stationary/newton_system.h"

#include <optional>
#include <vector>

namespace sbeh::surface3d {

/// The perturbation u along the normal, b of the order on nodes that move so; ∫(u² + b²) dS = 1, the largest |u| (or,
/// where that is 0, |b|) positive.
struct Eigenmode {
  double eigenvalue;  ///< λ: δ²F = λ ∫(u² + b²) dS
  Field u, b;         // nodes
};

/// The `count` lowest at the state at which the system is linearised, ascending, fewer where there are no more; all
/// negative ones are among them, however many. Empty where the iteration does not settle.
std::optional<std::vector<Eigenmode>> lowest_modes(const NewtonSystem& system,
                                                   const StationaryState& state,
                                                   const Nodes& normals, int count);

}  // namespace sbeh::surface3d
