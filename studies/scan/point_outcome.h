// What a point of a scan is found to be: a state, a fold, a limit, or nothing.
#pragma once

#include "axisym/stationary/limit_shape.h"
#include "studies/scan/branch_points.h"

#include <optional>

namespace sbeh::studies {

/// The case at another place.
axisym::StationaryCase moved_to(const axisym::PlanePoint& at, axisym::StationaryCase of);

/// What a state is, apart from the branch that led to it.
PointOutcome outcome_of(const axisym::StationaryCase& of, const axisym::StationaryState& state,
                        const axisym::Diagnostics& diagnostics);

/// A state that is there, on as many elements as its errors need.
PointOutcome resolved_point(const axisym::StationaryCase& of, const axisym::BranchState& state);

/// What SSH's stomatocytes, pears and dumbbells of about this V_r tend to; nothing where dumbbells have unequal parts.
std::optional<axisym::TouchingSpheres> limit_of(axisym::Branch branch, double reduced_volume,
                                                int spheres);

/// The values of such a limit, which are exact.
void put_limit(const axisym::StationaryCase& of, const axisym::TouchingSpheres& spheres,
               PointResult& row);

/// Where a neck closes, of which `last` is the last state: what the branch tends to.
PointOutcome limit_point(const axisym::StationaryCase& of, const axisym::BranchState& last);

/// Where the following of a line has ended. `share`: of what is given of κ, κ_G, f, at the line's end.
PointOutcome outcome_of(const axisym::StationaryCase& of, const axisym::FollowResult& result,
                        double share = 1);

}  // namespace sbeh::studies
