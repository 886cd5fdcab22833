#include "tools/picture/chart/history.h"

#include "studies/states/series_file.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace sbeh::picture {

Points log_log(const std::vector<double>& time, const std::vector<double>& value, double shift) {
  constexpr double resolution = 0.004;  // of a decade
  constexpr double shown = 1e-6;        // of the last time: what is earlier looks like the start
  const double first = time.empty() ? 0.0 : shown * time.back();
  Points points;
  for (std::size_t i = 0; i < time.size(); ++i) {
    if (!(time[i] > 0.0) || time[i] < first || !(value[i] + shift > 0.0)) continue;
    const double x = std::log10(time[i]), y = std::log10(value[i] + shift);
    const bool last = i + 1 == time.size();
    const bool new_place = points.empty() || std::abs(x - points.back()[0]) > resolution
                        || std::abs(y - points.back()[1]) > resolution;
    if (std::isfinite(x) && std::isfinite(y) && (new_place || last)) points.push_back({x, y});
  }
  return points;
}

Points energy_over_time(const std::filesystem::path& series, double shift) {
  std::vector<double> time, energy;
  for (const studies::SeriesRow& row : studies::read_rows(studies::series_columns(), series)) {
    time.push_back(row.record.time);
    energy.push_back(row.record.energy.total());
  }
  return log_log(time, energy, shift);
}

HistoryAxes history_axes(const std::vector<Points>& curves, const std::string& energy_name) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  double low[2] = {infinity, infinity}, high[2] = {-infinity, -infinity};
  for (const Points& curve : curves) {
    for (const auto& point : curve) {
      for (int c = 0; c < 2; ++c) {
        low[c] = std::min(low[c], point[c]);
        high[c] = std::max(high[c], point[c]);
      }
    }
  }
  const double margin = 0.04 * (high[1] - low[1]);
  return {decade_axis(low[0], high[0], "t"),
          decade_axis(low[1] - margin, high[1] + margin, energy_name)};
}

}  // namespace sbeh::picture
