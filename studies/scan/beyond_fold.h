// What lies beyond the folds of a scan's oblates, and whether it is stable in 3D.
#pragma once

#include "axisym/modes/stability_3d.h"
#include "axisym/rim/beyond_fold.h"
#include "studies/scan/branch_lines.h"

#include <string>
#include <vector>

namespace sbeh::studies {

/// A state of axisym/rim/beyond_fold.h. Its modes are those of the same state over P3 elements; not known of a kink, which
/// no elements resolve, at a fold, where an eigenvalue is zero, and of a limit. Of a rim too sharp for them there is
/// rigid_residual alone, or nothing.
struct RimRow : axisym::RimRecord {
  axisym::Stability3d modes{};
};

/// Those at every reduced volume above 0.51 whose oblates fold below twice the scan's largest L, for its values of L. In
/// parallel; incomplete when interrupted.
std::vector<RimRow> find_beyond_fold(const ScanInput& input, const std::vector<FoldRow>& folds);
/// Name of the state's profile without ending, such as sharp_v0.6_L0.05.
std::string stem(const axisym::RimRecord& row);
/// The columns of a profile (profile_file.h) but the last: at a kink the curvature is infinite.
std::string profile_text(const axisym::State& state);

/// Of beyond_fold.csv, whose `status` is unresolved where the resolution is above largest_resolution (axisym/flow.h), and
/// limit of nested spheres.
const Columns<RimRow>& rim_columns();

}  // namespace sbeh::studies
