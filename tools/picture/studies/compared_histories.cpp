#include "studies/compare/compare.h"
#include "tools/picture/chart/history.h"
#include "tools/picture/chart/legend.h"
#include "tools/picture/studies/method_style.h"
#include "tools/picture/studies/studies.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace sbeh::picture {
namespace {

using studies::Witness;

struct History {
  Witness method;
  std::vector<double> time{}, energy{};
};

std::vector<History> read_histories(const std::filesystem::path& file, const Options& options) {
  std::vector<History> histories;
  for (const studies::HistoryRow& row : studies::read_rows(studies::history_columns(), file)) {
    if (histories.empty() || histories.back().method != row.method)
      histories.push_back({.method = row.method});
    histories.back().time.push_back(options.factor(studies::dimension::time) * row.at.time);
    histories.back().energy.push_back(options.factor(studies::dimension::energy) * row.at.energy);
  }
  return histories;
}

// So that all are seen where they agree.
std::vector<std::size_t> widest_first(const std::vector<History>& histories) {
  std::vector<std::size_t> order(histories.size());
  std::iota(order.begin(), order.end(), 0);
  std::ranges::sort(order, std::ranges::greater(),
                    [&](std::size_t k) { return style_of(histories[k].method).width; });
  return order;
}

// (log₁₀ t, |difference from the first|) at the times that both have.
Points differences(const History& of, const History& from) {
  std::vector<double> time, difference;
  for (std::size_t i = 0; i < of.time.size(); ++i) {
    const auto at = std::lower_bound(from.time.begin(), from.time.end(), 0.999999 * of.time[i]);
    if (at == from.time.end() || *at > 1.000001 * of.time[i]) continue;
    time.push_back(of.time[i]);
    difference.push_back(std::abs(of.energy[i] - from.energy[std::size_t(at - from.time.begin())]));
  }
  return over_time(time, difference, 0);
}

// What the flow starts from is alike but for the surface: nothing to be seen below a billionth of the largest.
Axis difference_axis(const std::vector<Points>& all, const std::string& title) {
  Range range;
  for (const Points& points : all)
    for (const auto& point : points)
      if (point[1] > 0.0) range.include(point[1]);
  if (range.low > range.high) return decade_axis(-16.0, -15.0, title);
  return decade_axis(std::log10(std::max(range.low, 1e-9 * range.high)) - 0.1,
                     std::log10(range.high) + 0.1, title);
}

Points on_decades(const Points& points, const Axis& axis) {
  Points shown;
  for (const auto& [x, y] : points)
    if (y > 0.0 && std::log10(y) >= axis.low) shown.push_back({x, std::log10(y)});
  return shown;
}

}  // namespace

void draw_compared_histories(Canvas& canvas, const Options& options) {
  const std::filesystem::path file = options.directory / "histories.csv";
  if (!std::filesystem::exists(file)) {
    if (!options.only.empty()) fmt::print("no histories: no two methods follow an evolution\n");
    return;
  }
  const std::vector<History> histories = read_histories(file, options);
  std::vector<Points> energies, misses;
  std::vector<LegendEntry> legend;
  for (const History& history : histories) {
    energies.push_back(over_time(history.time, history.energy, 0));
    misses.push_back(differences(history, histories.front()));
    legend.push_back(line_entry(style_of(history.method), name(history.method)));
  }
  const double text = options.text_size(), width = options.width(900.0);
  const double left = 6.6 * text, right = 1.6 * text, below = below_axis(text);
  const double legend_at = legend_height(canvas, legend, width - 2.0 * text, text);
  const double fixed = legend_at + 0.8 * text + 2.0 * below + 2.4 * text;
  const double height = options.height(fixed + 0.75 * (width - left - right));
  const double both = height - fixed, inner = width - left - right;
  const Rect lower{left, legend_at + 0.8 * text + below, inner, 0.4 * both};
  const Rect upper{left, lower.y + lower.height + 1.2 * text + below, inner, 0.6 * both};
  const HistoryAxes axes =
      history_axes(energies, EnergyScale::linear, "energy U", upper.height, options);
  canvas.start(width, height, options.unit());
  Chart above(canvas, upper, text, axes.time, axes.energy);
  const Axis off = difference_axis(
      misses, options.titled(std::string("|U \u2212 U of ") + name(histories.front().method) + "|",
                             studies::dimension::energy));
  Chart beneath(canvas, lower, text, axes.time, off);
  for (const std::size_t k : widest_first(histories)) {
    above.curve(energies[k], style_of(histories[k].method));
    if (k > 0) beneath.curve(on_decades(misses[k], off), style_of(histories[k].method));
  }
  draw_legend(canvas, legend, {text, 0.4 * text, width - 2.0 * text, legend_at}, text);
  canvas.write(options.directory / "histories", options.output());
}

}  // namespace sbeh::picture
