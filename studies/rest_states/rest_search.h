// States that no branch leads to: Newton's method from displaced states, kept away from those that are known.
#pragma once

#include "studies/rest_states/rest_branch.h"
#include "studies/rest_states/rest_state.h"

namespace sbeh::studies {

/// Looks for states from the first one, and from each that is found: displaced along its lowest modes, both ways, until as many are
/// known as the input wants, or none is new, or an interrupt. What the triangles do not resolve gets new ones. Tells `take` of the first
/// and of each new one; `number` of the row that is to come is asked for.
void search_states(const StatesInput& input, const RestState& first,
                   const std::function<int()>& number, const TakeState& take);

}  // namespace sbeh::studies
