// A study of stability in 3D: axisymmetric states over a (V_r, L) grid, revolved and perturbed, run by run,
// resumable.
#pragma once

#include "studies/stability/stability_run.h"

namespace sbeh::studies {

/// Where the least stable mode of a Y_lm at one L begins to grow, or ceases to, between two neighbouring reduced
/// volumes.
struct Threshold {
  StabilityKey below{};  ///< the lower one; its `reduced_volume` is not that of the zero
  double upper_volume = 0;
  double reduced_volume = not_known;  ///< where the mode's eigenvalue is 0
  double error = not_known;           ///< as in axisym/modes/threshold.h
  /// Of the classical oblate and prolate by spherical harmonics: where the number of directions in which
  /// the energy falls changes, by bisection to 1e-4; `not_known` where the method does not reach.
  double harmonics = not_known;
};

/// From all rows, in the order of their keys: where the sign of the eigenvalue changes from one to the next. Without a
/// volume where the branch is lost on the way.
std::vector<Threshold> find_thresholds(const StabilityInput& input,
                                       const std::vector<StabilityResult>& rows);

/// Of thresholds.csv.
const Columns<Threshold>& threshold_columns();

struct StabilitySummary {
  std::vector<StabilityResult> rows;  ///< all there are
  std::vector<Threshold> thresholds;
  int computed = 0;  ///< in this call; the rest was there
  bool interrupted = false;
  double seconds = 0;
};

/// Runs the study into a folder: run.toml (the resolved input), stability.csv (a row per run as it
/// finishes, in the order of the keys at the end), runs/ (a history per run), thresholds.csv (where
/// eigenvalues change their sign). Runs that are there are not repeated; a folder that holds another study is refused.
/// Progress goes to standard error. Throws OutputError.
StabilitySummary run_stability(const StabilityInput& input, const std::filesystem::path& folder,
                               std::string_view version);

/// The rows as a table for people.
std::string table_of(const StabilitySummary& summary);

}  // namespace sbeh::studies
