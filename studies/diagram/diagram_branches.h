// The branches of one line of a diagram, and what is special on them.
#pragma once

#include "axisym/diagram/traced_branches.h"
#include "studies/diagram/diagram_input.h"

#include <vector>

namespace sbeh::studies {

using DiagramBranch = axisym::TracedBranch;

/// Where the branches of the bilayer couple begin: those with H₀ = 0, on which no moment acts.
std::vector<DiagramBranch> classical_diagram_branches(const DiagramInput& input);

/// All at one value: the symmetric ones, and what leaves them. `classical` is looked at for the bilayer couple alone; else
/// oblates and prolates are found near the sphere.
std::vector<DiagramBranch> branches_at(const DiagramInput& input, double value,
                                       const std::vector<DiagramBranch>& classical);

}  // namespace sbeh::studies
