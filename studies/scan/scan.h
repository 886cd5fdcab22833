// A scan: every point of a (V_r, L) grid, in parallel, row by row, resumable.
#pragma once

#include "studies/io/part.h"
#include "studies/scan/scan_input.h"

#include <filesystem>
#include <string>
#include <string_view>

namespace sbeh::studies {

struct ScanSummary {
  int points = 0, stationary = 0, unresolved = 0, limit = 0, failed = 0;
  std::string first_failure{};  ///< the reason of the first failed point
  int computed = 0;             ///< in this call; the rest was there
  int lowest_not_found = 0;     ///< rows of lowest.csv
  bool interrupted = false;
  double seconds = 0;
};

/// Runs the scan into a folder: run.toml (the resolved input), scan.csv (a row per point as it
/// finishes, in the order of the grid at the end), points/ (a profile per point, and the energy
/// history for the method flow). Points that are there are not repeated; a folder that holds another
/// scan is refused. Progress goes to standard error. Throws OutputError.
ScanSummary run_scan(const ScanInput& input, const std::filesystem::path& folder,
                     std::string_view version);

/// The same for some of the reduced volumes alone, by their place in the input, into a folder of its own within that of the
/// scan, such as parts/3_of_16, where the lines between points are not looked for. run_scan takes the points of all parts
/// over, computes what is missing, and leaves what it leaves without parts.
ScanSummary run_scan_part(const ScanInput& input, const std::filesystem::path& folder,
                          const Part& part, std::string_view version);

/// Where a part has its results.
std::filesystem::path part_folder(const std::filesystem::path& folder, const Part& part);

}  // namespace sbeh::studies
