// Where two branches have the same energy.
#pragma once

#include "axisym/stationary/arclength.h"

#include <span>
#include <vector>

namespace sbeh::axisym {

/// States with the same energy at the same V_r, A and V.
struct EqualEnergy {
  BranchState first, second;
  double energy;
  double error;  ///< estimated, of V_r
};

/// Of two pieces of paths on the same line, each with states in the order of μ, its energies between them by cubics with
/// dU/dV = P. Where the solver does not settle on both, nothing is found.
std::vector<EqualEnergy> equal_energies(const Line& line, std::span<const PathState> first,
                                        std::span<const PathState> second,
                                        const Numerics& numerics);

}  // namespace sbeh::axisym
