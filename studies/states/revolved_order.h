// The order with which a surface of revolution begins.
#pragma once

#include "axisym/curve.h"
#include "studies/states/initial_order.h"

namespace sbeh::studies {

/// Puts the pattern on the order of a state, and brings a conserved one to its mean. Throws std::invalid_argument where the order leaves
/// −1 … 1 or is far from the mean.
void complete_order(const model::Material& material, const OrderPattern& pattern,
                    axisym::State& state);

}  // namespace sbeh::studies
