// The domains of an order on a surface of revolution.
#pragma once

#include "axisym/curve.h"
#include "model/domains.h"

namespace sbeh::axisym {

/// Caps and belts, on the cones between the nodes.
model::Domains domains_of(const State& state);

}  // namespace sbeh::axisym
