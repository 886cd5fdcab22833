// The other states of a scan's branches: saddles, and minima of higher energy.
#pragma once

#include "studies/scan/scan_table.h"

#include <filesystem>
#include <vector>

namespace sbeh::studies {

/// A row of further.csv: as in scan.csv, the branch's state number 2, 3 …
struct FurtherRow : PointResult {
  int number = 2;
};

/// For every branch and reduced volume SSH's other states (traced_states.h) with at most input.further negative directions, by their
/// number and energy; for SBEH what they lead to along L. Rows that are stationary, in the order of scan.csv. Writes their profiles
/// into `points/` of the folder, such as SSH_pear-2_v0.8_L0.05.csv. Incomplete when interrupted.
std::vector<FurtherRow> find_further(const ScanInput& input, const ScanTable& table,
                                     const std::filesystem::path& folder);

const Columns<FurtherRow>& further_columns();

}  // namespace sbeh::studies
