// The domains of an order on a surface of revolution.
#pragma once

#include "axisym/curve.h"
#include "model/domains.h"

#include <vector>

namespace sbeh::axisym {

/// Caps and belts, on the cones between the nodes.
model::Domains domains_of(const State& state);

/// A circle on which the order passes the middle of its extremes, β going with tanh(s/width) there.
struct Interface {
  double node;   ///< between which nodes: 2.5 is half way from the third to the fourth
  double width;  ///< > 0
};
/// From north to south; none where the order is the same everywhere but for model::Domains::least_contrast.
std::vector<Interface> interfaces(const State& state);

}  // namespace sbeh::axisym
