// Where the nodes sit along the generating curve.
#pragma once

#include "axisym/stationary.h"

namespace sbeh::axisym {

/// Moves the nodes along the curve so that every element carries the same share of
///   ∫ (1/length + grading · |B_ss| / ∫|B_ss|) ds,
/// B_ss the curvature of the generating curve; within an element the nodes are equidistant in arc
/// length, since a rough placing there would cost the elements their order. All fields are interpolated; the curve changes by its interpolation error only.
/// elements = 0 keeps their number.
State redistribute(const State& state, double grading, int elements = 0);
StationaryState redistribute(const StationaryState& state, double grading, int elements = 0);

}  // namespace sbeh::axisym
