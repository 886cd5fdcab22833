// A study of stability in 3D: axisymmetric states over a (V_r, L) grid, revolved and perturbed, run by run,
// resumable.
#pragma once

#include "studies/stability/stability_input.h"
#include "studies/stability/stability_thresholds.h"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace sbeh::studies {

struct StabilitySummary {
  std::vector<StabilityResult> rows;  ///< all there are
  std::vector<Threshold> thresholds;
  int computed = 0;  ///< in this call; the rest was there
  bool interrupted = false;
  double seconds = 0;
};

/// Runs the study into a folder: run.toml (the resolved input), stability.csv (a row per run as it
/// finishes, in the order of the keys at the end), runs/ (a history per run), thresholds.csv (where rates
/// change their sign). Runs that are there are not repeated; a folder that holds another study is refused.
/// Progress goes to standard error. Throws OutputError.
StabilitySummary run_stability(const StabilityInput& input, const std::filesystem::path& folder,
                               std::string_view version);

/// The rows as a table for people.
std::string table_of(const StabilitySummary& summary);

}  // namespace sbeh::studies
