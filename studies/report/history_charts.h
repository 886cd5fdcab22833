// The charts of an evolution: which columns of series.csv they show.
#pragma once

#include "studies/io/csv.h"
#include "studies/report/result_units.h"
#include "studies/report/svg_chart.h"

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace sbeh::studies {

struct HistoryChart {
  ChartFrame frame;
  std::vector<std::pair<const char*, const char*>> columns;  ///< and what they are called
  double least_dissipation = 0.0;  ///< of its largest: below, the values say nothing
};
/// Named with their units, where there are some.
std::vector<HistoryChart> history_charts(const std::optional<ResultUnits>& units = {});

/// All of them, as still pictures, of a table in these units.
std::string still_charts(const CsvTable& series, const std::optional<ResultUnits>& units = {});

/// A table for live ones, a row per column: title, y_name, logarithmic, least_dissipation, column, called.
std::string table_of_charts(const std::optional<ResultUnits>& units = {});

}  // namespace sbeh::studies
