#include "studies/report/history_charts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace sbeh::studies {

namespace {

const std::vector<HistoryChart>& dimensionless_charts() {
  constexpr auto log = AxisScale::logarithmic;
  static const std::vector<HistoryChart> all{
      {{"Energy", log, AxisScale::linear, "U"}, {{"energy", "U"}}},
      {{"Order β", log, AxisScale::linear, "β"},
       {{"order_min", "least"}, {"order_mean", "mean"}, {"order_max", "largest"}}},
      {{"Dissipation", log, log, "−dU/dt"},
       {{"dissipation_friction", "friction"},
        {"dissipation_order", "order"},
        {"dissipation_viscous", "viscous"}}},
      {{"Energy lost over energy dissipated in a step, while 1e-4 of the most is dissipated", log,
        AxisScale::linear, "ratio"},
       {{"energy_balance", "ratio"}},
       1e-4},
      {{"Largest |H|", log, AxisScale::linear, "|H|"}, {{"H_abs_max", "|H|"}}},
      {{"Time step and largest speed", log, log, "τ, |V|"},
       {{"time_step", "time step"}, {"speed_max", "speed"}}},
      {{"Mesh quality", log, AxisScale::linear, "quality"}, {{"mesh_quality", "quality"}}},
  };
  return all;
}

// Of a chart of several quantities each has its own.
std::string y_name_of(const HistoryChart& chart, const ResultUnits& units) {
  std::string names;
  for (const auto& [column, called] : chart.columns) {
    const std::string unit = units.unit(*dimension_of(column));
    if (!unit.empty() && names.find(unit) == std::string::npos)
      names += (names.empty() ? "" : ", ") + unit;
  }
  return names.empty() ? chart.frame.y_name : fmt::format("{} ({})", chart.frame.y_name, names);
}

}  // namespace

std::vector<HistoryChart> history_charts(const std::optional<ResultUnits>& units) {
  std::vector<HistoryChart> charts = dimensionless_charts();
  if (units)
    for (HistoryChart& chart : charts) {
      chart.frame.x_name = units->titled("t", dimension::time);
      chart.frame.y_name = y_name_of(chart, *units);
    }
  return charts;
}

std::string still_charts(const CsvTable& series, const std::optional<ResultUnits>& units) {
  const auto numbers = [&](const char* column) {
    std::vector<double> values;
    for (std::size_t row = 0; row < series.rows.size(); ++row)
      values.push_back(series.number(row, column));
    return values;
  };
  const std::vector<double> time = numbers("time");
  std::vector<double> dissipation(time.size());
  for (const char* column : {"dissipation_friction", "dissipation_order", "dissipation_viscous"})
    if (series.find(column))
      std::ranges::transform(dissipation, numbers(column), dissipation.begin(), std::plus{});
  double most = 0.0;
  for (const double value : dissipation) most = std::fmax(most, value);
  const auto shown = [&](std::vector<double> values, double least) {
    for (std::size_t row = 0; row < values.size(); ++row)
      if (dissipation[row] < least * most) values[row] = not_known;
    return values;
  };
  std::string text;
  for (const HistoryChart& chart : history_charts(units)) {
    std::vector<ChartLine> lines;
    for (const auto& [column, called] : chart.columns)
      if (series.find(column))
        lines.push_back({called, time, shown(numbers(column), chart.least_dissipation)});
    text += svg_chart(chart.frame, lines);
  }
  return text;
}

std::string table_of_charts(const std::optional<ResultUnits>& units) {
  std::string table = "title,y_name,logarithmic,least_dissipation,column,called\n";
  for (const HistoryChart& chart : history_charts(units))
    for (const auto& [column, called] : chart.columns)
      table += fmt::format("{},{},{:d},{},{},{}\n", csv_field(chart.frame.title),
                           csv_field(chart.frame.y_name), chart.frame.y == AxisScale::logarithmic,
                           chart.least_dissipation, column, csv_field(called));
  return table;
}

}  // namespace sbeh::studies
