// The charts of an evolution: which columns of series.csv they show.
#pragma once

#include "studies/io/csv.h"
#include "studies/report/svg_chart.h"

#include <string>
#include <utility>
#include <vector>

namespace sbeh::studies {

struct HistoryChart {
  ChartFrame frame;
  std::vector<std::pair<const char*, const char*>> columns;  ///< and what they are called
  double least_dissipation = 0.0;  ///< of its largest: below, the values say nothing
};
const std::vector<HistoryChart>& history_charts();

/// All of them, as still pictures.
std::string still_charts(const CsvTable& series);

/// A table for live ones, a row per column: title, y_name, logarithmic, least_dissipation, column, called.
std::string table_of_charts();

}  // namespace sbeh::studies
