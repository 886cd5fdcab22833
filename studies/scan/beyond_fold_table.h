// The states beyond the fold of the oblates, as a scan leaves them.
#pragma once

#include "axisym/rim/beyond_fold.h"
#include "studies/scan/branch_lines.h"

namespace sbeh::studies {

/// The states of axisym/rim/beyond_fold.h at every reduced volume above 0.51 whose oblates fold below twice
/// the scan's largest L, for its values of L. In parallel; incomplete when interrupted.
std::vector<axisym::RimRecord> find_beyond_fold(const ScanInput& input,
                                                const std::vector<FoldRow>& folds);

/// beyond_fold.csv: reduced_volume,L,kind,energy,order_rim,H_rim,H_abs_max,resolution,status,jump,pressure,
/// negative_directions. `status` is unresolved where the resolution is above resolution_limit (flow.h).
std::string table_of(const std::vector<axisym::RimRecord>& rows);

/// Name of the state's profile without ending, such as sharp_v0.6_L0.05.
std::string stem(const axisym::RimRecord& row);
/// The profile: arc_length,r,z,order, a row per node from pole to pole. There is no curvature in it: at a
/// kink it is infinite.
std::string profile_text(const axisym::State& state);

}  // namespace sbeh::studies
