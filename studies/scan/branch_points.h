// Single points of a scan along a branch, each from its neighbour or from an ellipsoid.
//
// Neighbours are handed on as positions and order alone, which is what a point's file keeps, so that
// a resumed scan continues from the same bits as an uninterrupted one.
#pragma once

#include "axisym/flow.h"
#include "axisym/stationary/branch_entry.h"
#include "studies/evolution/series_file.h"
#include "studies/scan/scan_table.h"

#include <optional>
#include <vector>

namespace sbeh::studies {

/// A row and the state it describes; no state where the point failed.
struct PointOutcome {
  PointResult row;
  std::optional<axisym::State> state;
};

/// A stationary state to start from.
struct Neighbour {
  axisym::PlanePoint at;
  axisym::State state;
};

/// A failed point, with the reason.
PointOutcome failed_point(const PointKey& key, std::string reason);

/// Newton's method from positions and order alone; empty when it fails.
std::optional<axisym::BranchState> settled(const model::Material& material, model::Model model,
                                           const Neighbour& at);

/// SSH's state from which a branch is followed, at the elastic constant L; empty when Newton fails.
std::optional<Neighbour> enter_branch(const ScanInput& input, axisym::Branch branch, double L);

/// Follows the branch of `model` from a neighbour (of the same model) to the point of the key.
PointOutcome follow_to(const ScanInput& input, const PointKey& key, const Neighbour& from);

/// SSH's state with another elastic constant: the same shape unless k₀ or H₀ is there.
PointOutcome rescale_to(const ScanInput& input, const PointKey& key, const Neighbour& from);

/// An L well below any fold: stomatocytes with V_r = 0.5 fold at 7e-5.
inline constexpr double small_L = 1e-5;

/// The first SBEH state at a reduced volume, from SSH's: at a small L, then along the branch.
PointOutcome order_from(const ScanInput& input, const PointKey& key, const Neighbour& ssh);

/// The point beyond a fold: the fold's row and state under another L.
PointOutcome beyond_fold(const PointKey& key, const PointOutcome& fold);

/// The fold in which a branch of SBEH ends as L grows, at the reduced volume of a state on it; empty
/// when there is none below L = 2.
std::optional<axisym::BranchState> fold_above(const ScanInput& input, const Neighbour& from);

/// V_r = 1: the sphere, with the uniform order at rest there.
PointOutcome sphere_point(const ScanInput& input, const PointKey& key);

/// The flow from the spheroid (oblate or prolate) with β = 2/3 to rest, polished by Newton's method. Records
/// every accepted step. Empty when interrupted.
std::optional<PointOutcome> flow_to_rest(const ScanInput& input, const PointKey& key,
                                         std::vector<SeriesRow>& history);

}  // namespace sbeh::studies
