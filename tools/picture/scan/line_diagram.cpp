#include "tools/picture/chart/legend.h"
#include "tools/picture/scan/quantity.h"
#include "tools/picture/scan/scan.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace sbeh::picture {
namespace {

const LineStyle sbeh_style{.colour = {0, 84, 159}, .width = 2.4};
const LineStyle ssh_style{.colour = red, .width = 2.4, .dashed = true};

// One curve: a quantity along the parameter that varies.
struct Series {
  Quantity quantity;
  LineStyle style;
  std::string name;

  double value(std::size_t i) const {
    return quantity.values.size() > 1 ? quantity.values[i][0] : quantity.values[0][i];
  }
  Mark mark(std::size_t i) const {
    return quantity.marks.size() > 1 ? quantity.marks[i][0] : quantity.marks[0][i];
  }
};

struct Panel {
  std::string title;
  std::vector<Series> series;
};

std::vector<Panel> panels_of(const ScanGrid& scan) {
  const auto of_models = [&](Quantity (*quantity)(const ScanGrid&, Model)) {
    std::vector<Series> all;
    for (const Model model : {Model::SSH, Model::SBEH})
      if (scan.has(model))
        all.push_back({quantity(scan, model), model == Model::SBEH ? sbeh_style : ssh_style,
                       sbeh::name(model)});
    return all;
  };
  std::vector<Panel> panels;
  if (scan.has(Model::SBEH) && scan.has(Model::SSH)) {
    const Quantity gap = energy_gap(scan);
    panels.push_back({gap.title, {{gap, {.colour = black, .width = 2.4}, ""}}});
  } else {
    fmt::print("diagram: only one model, so the energy itself in place of the energy gap\n");
    panels.push_back({"energy U", of_models(energy)});
  }
  if (scan.has(Model::SBEH))
    panels.push_back({"smallest order β", {{smallest_order(scan), sbeh_style, "SBEH"}}});
  panels.push_back({"largest |H|", of_models(largest_curvature)});
  return panels;
}

// In all panels, of the lowest of several branches.
void mark_not_found(const ScanGrid& scan, const Options& options, std::vector<Panel>& panels) {
  if (!options.branch.empty()) return;
  for (const Model model : {Model::SSH, Model::SBEH})
    if (const auto lowest = lowest_branches(scan, options.directory, model))
      for (Panel& panel : panels)
        for (Series& series : panel.series)
          // The gap, which has no name, is one of SBEH's lowest too.
          if (series.name == sbeh::name(model) || (series.name.empty() && model == Model::SBEH))
            mark_not_found(*lowest, series.quantity);
}

// Some room on either side, so that no marker is cut.
Axis roomy_axis(double low, double high, double length, double spacing, const char* title) {
  const double room = high > low ? 0.06 * (high - low) : 0.05 * std::abs(high) + 1e-12;
  return exact_axis(low - room, high + room, length, spacing, title);
}

Axis value_axis(const Panel& panel, double length, double spacing) {
  Range range;
  for (const Series& series : panel.series) {
    range.include(series.quantity.range().low);
    range.include(series.quantity.range().high);
  }
  return roomy_axis(range.low, range.high, length, spacing, "");
}

void draw_series(Chart& chart, const Series& series, const std::vector<double>& x, const Axis& y,
                 double marker) {
  Points line, good, unresolved, failed, not_found;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double value = series.value(i);
    if (!std::isfinite(value)) {
      const std::array<double, 2> below{x[i], y.low + 0.03 * (y.high - y.low)};
      if (series.mark(i) == Mark::failed) failed.push_back(below);
      if (series.mark(i) == Mark::not_found) not_found.push_back(below);
      chart.curve(std::exchange(line, {}), series.style);
      continue;
    }
    const double shown = std::clamp(value, y.low, y.high);
    line.push_back({x[i], shown});
    (series.mark(i) == Mark::none ? good : unresolved).push_back(line.back());
  }
  chart.curve(line, series.style);
  chart.markers(good, Marker::full, series.style.colour, marker);
  chart.markers(unresolved, Marker::hollow, series.style.colour, marker);
  chart.markers(failed, Marker::cross, series.style.colour, marker);
  chart.markers(not_found, Marker::diamond, series.style.colour, marker);
}

std::vector<LegendEntry> legend_of(const std::vector<Panel>& panels) {
  std::vector<LegendEntry> entries;
  for (const Series& series : panels.back().series)
    entries.push_back(line_entry(series.style, series.name));
  std::ranges::reverse(entries);
  const auto marked = [&](Mark mark) {
    return std::ranges::any_of(panels, [&](const Panel& panel) {
      return std::ranges::any_of(panel.series,
                                 [&](const Series& s) { return s.quantity.has(mark); });
    });
  };
  if (marked(Mark::unresolved))
    entries.push_back(marker_entry(Marker::hollow, dark_grey, "unresolved"));
  if (marked(Mark::failed)) entries.push_back(marker_entry(Marker::cross, dark_grey, "failed"));
  if (marked(Mark::not_found))
    entries.push_back(marker_entry(Marker::diamond, dark_grey, "a lower state must exist"));
  return entries;
}

}  // namespace

void draw_line_diagram(Canvas& canvas, const ScanGrid& scan, const Options& options) {
  const bool over_volume = scan.lengths().size() == 1;
  const std::vector<double>& parameter = over_volume ? scan.reduced_volumes() : scan.lengths();
  std::vector<Panel> panels = panels_of(scan);
  mark_not_found(scan, options, panels);
  const auto legend = legend_of(panels);
  const double text = options.text_size();
  const auto count = double(panels.size());
  const double width = options.width(533.0 * count);
  const double left = 4.6 * text, right = 1.2 * text;
  const double inner_width = width / count - left - right;
  const double legend_at = legend_height(canvas, legend, width - 2.0 * text, text);
  const double below = below_axis(text) + 0.8 * text + legend_at, above = 4.6 * text;
  const double height = options.height(below + above + 0.85 * inner_width);
  const double inner_height = height - below - above;

  const Axis x = roomy_axis(parameter.front(), parameter.back(), inner_width, 3.5 * text,
                            over_volume ? "reduced volume Vᵣ" : "elastic constant L");

  canvas.start(width, height);
  canvas.text(
      0.5 * width, height - 1.4 * text,
      over_volume ? length_title(scan.lengths()[0]) : volume_title(scan.reduced_volumes()[0]),
      {.size = 1.15 * text});
  for (std::size_t i = 0; i < panels.size(); ++i) {
    const Rect inside{double(i) * width / count + left, below, inner_width, inner_height};
    const Axis y = value_axis(panels[i], inner_height, 3.0 * text);
    Chart chart(canvas, inside, text, x, y);
    for (const Series& series : panels[i].series)
      draw_series(chart, series, parameter, y, 0.6 * text);
    canvas.text(inside.centre_x(), inside.top() + 1.2 * text, panels[i].title, {.size = text});
  }
  draw_legend(canvas, legend, {text, 0.4 * text, width - 2.0 * text, legend_at}, text);
  canvas.write(options.directory / "diagram");
}

}  // namespace sbeh::picture
