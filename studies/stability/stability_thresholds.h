// Where a state changes from stable to unstable along V_r.
#pragma once

#include "studies/io/columns.h"
#include "studies/stability/stability_run.h"

#include <vector>

namespace sbeh::studies {

/// Zero of the rate of one mode at one L, between two neighbouring reduced volumes.
struct Threshold {
  StabilityKey below{};  ///< the lower one; its `reduced_volume` is not that of the zero
  double upper_volume = 0;
  double reduced_volume = 0;  ///< of the zero, by linear interpolation
  double error = 0;           ///< from those of the rates
  /// Of the classical oblate and prolate by spherical harmonics: where the number of directions in which
  /// the energy falls changes, by bisection to 1e-4; `not_known` where the method does not reach.
  double harmonics = not_known;
};

/// From all rows, in the order of their keys.
std::vector<Threshold> find_thresholds(const StabilityInput& input,
                                       const std::vector<StabilityResult>& rows);

/// Of thresholds.csv.
const Columns<Threshold>& threshold_columns();

}  // namespace sbeh::studies
