// Where the nodes sit along the generating curve.
#pragma once

#include "axisym/curve.h"
#include "axisym/options.h"

namespace sbeh::axisym {

/// Moves the nodes along the curve so that every element carries the same share of
///   ∫ (1/length + grading · |B_ss| / ∫|B_ss|) ds,
/// B_ss the curvature of the generating curve, and more of them near necks and interfaces between phases, on the scale of their radii
/// and widths. Within an element the fields become the cubics through
/// their values at its Gauss–Lobatto points in arc length: their error has no mean, so that area and
/// volume keep order 6. All fields are interpolated; the curve changes by its interpolation error only.
/// elements = 0 keeps their number.
State redistribute(const State& state, double grading, int elements = 0);
StationaryState redistribute(const StationaryState& state, double grading, int elements = 0);

/// To how many elements stationary states are refined at most.
inline constexpr int most_elements = 1024;

/// Redistributes over twice or half as many elements, most_elements at most and numerics.elements at least,
/// where curvature times spacing (`resolution`) is above 0.15 or below 0.05.
StationaryState fitted(const StationaryState& state, const Numerics& numerics);

/// Values at the Gauss–Lobatto points of the elements (joints shared, 3 elements + 1) as the nodal
/// values of the cubics through them.
Field nodal_values(const Field& at_lobatto);

/// A field over the nodes of `state` at the Gauss–Lobatto points of the elements that `redistribute`
/// would make.
Field sample_at_lobatto(const State& state, const Field& f, double grading, int elements);

}  // namespace sbeh::axisym
