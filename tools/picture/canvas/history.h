// The energy over time, ready for logarithmic axes.
#pragma once

#include "tools/picture/canvas/chart.h"

#include <filesystem>
#include <string>
#include <vector>

namespace sbeh::picture {

/// One column over time as points (log₁₀ t, log₁₀(value + shift)); rows where either is not positive
/// are left out, so are points too close to tell apart and those in the first millionth of the time.
struct History {
  std::vector<double> time;
  std::vector<double> value;

  Points log_log(double shift) const;
};

/// Throws InputError.
History read_history(const std::filesystem::path& file, const std::string& column);

/// Axes about all curves, with the same decades for all panels.
struct HistoryAxes {
  Axis time;
  Axis energy;
};

HistoryAxes history_axes(const std::vector<Points>& curves, const std::string& energy_name);

}  // namespace sbeh::picture
