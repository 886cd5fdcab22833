// Where a branch of states with domains begins: a spheroid whose order has several phases, on its way to rest.
#pragma once

#include "studies/scan/branch_points.h"
#include "studies/states/initial_order.h"

namespace sbeh::studies {

/// The spheroid (oblate or prolate) of the case with the pattern on the order that the mean of its material leaves, its nodes where
/// the pattern wants them. Throws std::invalid_argument where there is no such order.
axisym::State spheroid_with(const axisym::StationaryCase& of, const OrderPattern& pattern);

/// What Newton's method finds on the way of the flow from there with as many interfaces as the case has, as long as the flow keeps them: the
/// first minimum (within axisymmetry), or else what has the fewest negative directions. Failed where there is none.
PointOutcome point_with(const axisym::StationaryCase& of, const OrderPattern& pattern);

}  // namespace sbeh::studies
