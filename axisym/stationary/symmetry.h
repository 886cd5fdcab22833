// States that look the same upside down, and the upside-down of those that do not.
#pragma once

#include "axisym/stationary/newton_system.h"

namespace sbeh::axisym {

/// The state upside down: z to −z, the nodes in the opposite order.
StationaryState upside_down(const StationaryState& state);

/// Whether the nodes are mirror images of each other, about the middle of their height, within 1e-6.
bool is_symmetric(const Nodes& X);

/// How far the curve is from its mirror image: the largest difference along the normals, so that nodes may have
/// slid along it.
double asymmetry(const Nodes& X);
/// More than this is another state, and no rounding.
inline constexpr double broken_symmetry = 0.03;

/// The mean of the state and its upside-down, about the middle of its height.
StationaryState symmetric_part(const StationaryState& state);

/// The same of an increment of a symmetric state, whose north pole stays where it is.
Increment symmetric_part(const Increment& step, const Nodes& normals);

}  // namespace sbeh::axisym
