// Single points of a scan along a branch, each from its neighbour or from an ellipsoid.
//
// Neighbours are handed on as positions and order alone, which is what a point's file keeps, so that
// a resumed scan continues from the same bits as an uninterrupted one.
#pragma once

#include "axisym/flow.h"
#include "axisym/stationary/ssh_branch.h"
#include "studies/scan/scan_table.h"
#include "studies/states/series_file.h"

#include <optional>
#include <vector>

namespace sbeh::studies {

/// A row, whose key is left to the scan, and the state it describes.
struct PointOutcome {
  PointResult row;
  /// None where the point failed; H, Λ, Σ and P only where Newton's method has found it in this process.
  std::optional<axisym::StationaryState> state;
};

/// A stationary state to start from.
struct Neighbour {
  axisym::PlanePoint at;
  axisym::State state;
};

/// A failed point, with the reason.
PointOutcome failed_point(std::string reason);

/// Newton's method from positions and order alone; empty when it fails.
std::optional<axisym::BranchState> settled(const axisym::StationaryCase& of,
                                           const axisym::State& state,
                                           double tolerance = axisym::NewtonOptions{}.tolerance);

/// Whether the point has a state of its own, to go on from: one that passes through itself has.
bool has_state_here(const PointOutcome& point);

/// What modes up to cos(largest_m φ) say of the state of the point; nothing where there is none.
void add_modes(const axisym::StationaryCase& of, int largest_m, PointOutcome& point);

/// Of a point at whose reduced volume SSH's shape is not to be had, as `ssh`, computed at some L, says: for SSH the limit
/// or the fold at the L of this point, if it is one.
PointOutcome without_ssh(const axisym::StationaryCase& of, const PointOutcome& ssh,
                         double computed_at);

/// SSH's state of the branch.
PointOutcome ssh_point(const axisym::StationaryCase& of, axisym::SshBranch& branch);

/// Follows the branch to the case from a neighbour: along L at the same reduced volume, or straight on.
PointOutcome follow_to(const axisym::StationaryCase& of, const Neighbour& from);

/// SSH's state with another elastic constant: the same shape unless k₀ or H₀ is there.
PointOutcome rescale_to(const axisym::StationaryCase& of, const Neighbour& from);

/// An L well below any fold: stomatocytes with V_r = 0.5 fold at 7e-5.
inline constexpr double small_L = 1e-5;

/// The first SBEH state at a reduced volume, from SSH's: at a small L, then along the branch.
PointOutcome order_from(const axisym::StationaryCase& of, const axisym::State& ssh);

/// The state of the case, from the branch's entry on: SSH's, then for a free order along L.
PointOutcome branch_point(const axisym::StationaryCase& of);

/// The fold in which the branch of SBEH ends as L grows, from the case's state; empty when there is none below
/// L = 2.
std::optional<axisym::ResolvedState> fold_above(const axisym::StationaryCase& of,
                                                const axisym::State& state);

/// V_r = 1: the sphere, with the uniform order at rest there.
PointOutcome sphere_point(const axisym::StationaryCase& of);

/// The flow from the spheroid (oblate or prolate) with β = 2/3.
axisym::FlowResult flow_from_spheroid(const axisym::StationaryCase& of,
                                      const axisym::FlowSchedule& schedule,
                                      const axisym::FlowObserver& observe);

/// The same to rest until end_time at the latest, polished by Newton's method. Records every accepted step. Empty when interrupted.
std::optional<PointOutcome> flow_to_rest(const axisym::StationaryCase& of, double end_time,
                                         std::vector<SeriesRow>& history);

}  // namespace sbeh::studies
