// The states beyond the fold of the oblates, as a scan leaves them.
#pragma once

#include "axisym/rim/beyond_fold.h"
#include "studies/scan/branch_lines.h"

namespace sbeh::studies {

/// The states of axisym/rim/beyond_fold.h at every reduced volume above 0.51 whose oblates fold below twice
/// the scan's largest L, for its values of L. In parallel; incomplete when interrupted.
std::vector<axisym::RimRecord> find_beyond_fold(const ScanInput& input,
                                                const std::vector<FoldRow>& folds);

/// Of beyond_fold.csv; `status` is unresolved where the resolution is above resolution_limit (flow.h).
const Columns<axisym::RimRecord>& rim_columns();

/// Name of the state's profile without ending, such as sharp_v0.6_L0.05.
std::string stem(const axisym::RimRecord& row);
/// The columns of a profile (profile_file.h) but the last: at a kink the curvature is infinite.
std::string profile_text(const axisym::State& state);

}  // namespace sbeh::studies
