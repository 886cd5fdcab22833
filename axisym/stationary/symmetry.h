// States that look the same upside down, and the upside-down of those that do not.
#pragma once

#include "axisym/stationary/stationary.h"

namespace sbeh::axisym {

/// The state upside down: z to −z, the nodes in the opposite order.
StationaryState upside_down(const StationaryState& state);

/// Whether the nodes are mirror images of each other, about the middle of their height, within 1e-6.
bool is_symmetric(const Nodes& X);

/// The mean of the state and its upside-down, about the middle of its height.
StationaryState symmetric_part(const StationaryState& state);

}  // namespace sbeh::axisym
