// Energies over time, ready for logarithmic axes.
#pragma once

#include "tools/picture/canvas/geometry.h"
#include "tools/picture/chart/axis.h"

#include <filesystem>
#include <string>
#include <vector>

namespace sbeh::picture {

/// Points (log₁₀ t, log₁₀(value + shift)); those where either is not positive are left out, so are points
/// too close to tell apart and those in the first millionth of the time.
Points log_log(const std::vector<double>& time, const std::vector<double>& value, double shift);

/// Of the energy in a series.csv. Throws OutputError.
Points energy_over_time(const std::filesystem::path& series, double shift);

/// Axes about all curves, with the same decades for all panels.
struct HistoryAxes {
  Axis time;
  Axis energy;
};

HistoryAxes history_axes(const std::vector<Points>& curves, const std::string& energy_name);

}  // namespace sbeh::picture
