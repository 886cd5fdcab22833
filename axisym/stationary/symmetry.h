// States that look the same upside down, and the upside-down of those that do not.
#pragma once

#include "axisym/stationary/newton_system.h"

namespace sbeh::axisym {

/// The state upside down: z to −z, the nodes in the opposite order.
StationaryState upside_down(const StationaryState& state);

/// Whether the nodes are mirror images of each other, about the middle of their height, within 1e-6.
bool is_symmetric(const Nodes& X);

/// The mean of the state and its upside-down, about the middle of its height.
StationaryState symmetric_part(const StationaryState& state);

/// The same of an increment of a symmetric state that holds the north pole: both poles move instead, so that the
/// state stays symmetric and is not translated, which along the normals would change its shape.
Increment symmetric_part(const Increment& step, const Nodes& normals);

}  // namespace sbeh::axisym
