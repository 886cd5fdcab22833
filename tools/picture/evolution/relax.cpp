#include "studies/states/profile_file.h"
#include "studies/states/series_file.h"
#include "tools/picture/chart/history.h"
#include "tools/picture/chart/legend.h"
#include "tools/picture/chart/panels.h"
#include "tools/picture/evolution/evolution.h"
#include "tools/picture/section/cut.h"
#include "tools/picture/surface/frames.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>

namespace sbeh::picture {
namespace {

constexpr std::size_t most_shapes = 8;
constexpr std::size_t most_in_a_row = 5;
constexpr double shown_decades = 5;  // from the largest energy down: what is less is not seen in it
constexpr double rounding = 1e-9;    // of the largest energy

struct Part {
  std::string name;
  std::function<double(const model::Energy&)> of;
  double shift;
  LineStyle style;
};

// The total is the widest and below the others: at full order the bending energy is the same.
std::vector<Part> parts_of(const Options& options) {
  const std::string name = options.energy_name(), suffix = name.substr(1);  // " + 4π"
  const double shift = options.factor(studies::dimension::energy) * options.energy_shift;
  using model::Energy;
  return {{"total " + name, &Energy::total, shift, {.colour = black, .width = 4.5}},
          {"thermotropic" + suffix,
           &Energy::thermotropic,
           shift,
           {.colour = {0, 158, 115}, .width = 2.0, .pattern = Pattern::dashed}},
          {"bending", &Energy::bending, 0.0, {.colour = {240, 140, 40}, .width = 2.0}},
          {"distortion",
           &Energy::distortion,
           0.0,
           {.colour = {0, 114, 178}, .width = 2.0, .pattern = Pattern::dash_dotted}}};
}

struct Curve {
  Part part;
  Points points;
};

// The total first, and always; of the others those that are more than rounding.
std::vector<Curve> read_curves(const Options& options) {
  const auto series =
      studies::read_rows(studies::series_columns(), options.directory / "series.csv");
  const double energy = options.factor(studies::dimension::energy);
  std::vector<Curve> curves;
  double largest = 0.0;
  for (const Part& part : parts_of(options)) {
    std::vector<double> time, value;
    double own = 0.0;
    for (const studies::SeriesRow& row : series) {
      time.push_back(options.factor(studies::dimension::time) * row.record.time);
      value.push_back(energy * part.of(row.record.energy));
      own = std::max(own, std::abs(value.back() + part.shift));
    }
    largest = std::max(largest, own);
    if (!curves.empty() && own < rounding * largest) continue;
    curves.push_back({part, over_time(time, value, part.shift)});
  }
  return curves;
}

// A part that begins at 0 is that but for rounding, which is no reason for a linear scale.
EnergyScale scale_of(const std::vector<Curve>& curves, double largest) {
  std::vector<Points> points;
  for (const Curve& curve : curves) {
    points.push_back(curve.points);
    if (points.size() > 1)
      std::erase_if(points.back(),
                    [&](const auto& p) { return std::abs(p[1]) < rounding * largest; });
  }
  return scale_for(points);
}

// As drawn. On a logarithmic scale only the total is shown where it is far below the largest.
std::vector<Points> drawn(const std::vector<Curve>& curves, EnergyScale scale, const Range& range) {
  const double floor = std::log10(range.high) - shown_decades;
  std::vector<Points> all;
  all.reserve(curves.size());
  for (const Curve& curve : curves)
    all.push_back(all.empty() ? on_scale(curve.points, scale, range.width())
                              : on_scale(curve.points, scale, range.width(), floor));
  return all;
}

// log₁₀ of the total above its least value, in which a fall is seen that is small beside the energy itself; empty where
// there is none.
Points above_least(const Curve& total, double noise) {
  double least = std::numeric_limits<double>::infinity();
  for (const auto& point : total.points) least = std::min(least, point[1]);
  Points above;
  for (const auto& [time, energy] : total.points) above.push_back({time, energy - least});
  std::erase_if(above, [&](const auto& point) { return point[1] <= noise; });
  const Points shown = on_scale(above, EnergyScale::logarithmic, 1.0);
  return shown.size() > 1 ? shown : Points{};
}

void draw_fall(Canvas& canvas, const Rect& inside, const Points& fall, const Part& total,
               const Axis& time, const Options& options) {
  const double text = options.text_size();
  const HistoryAxes axes = history_axes({fall}, EnergyScale::logarithmic, "total above its least",
                                        inside.height, options);
  Chart(canvas, inside, text, time, axes.energy).curve(fall, total.style);
}

// Charts below each other, with the same axis of time.
PanelGrid stacked(std::size_t count, double bottom, double text, const Options& options) {
  return arranged({.count = count,
                   .most_columns = 1,
                   .usual_width = 1000.0,
                   .height_by_width = count == 1 ? 0.6 : 0.42,
                   .left = 5.6 * text,
                   .right = 1.6 * text,
                   .below = below_axis(text),
                   .above = 1.2 * text,
                   .bottom = bottom},
                  options);
}

}  // namespace

void draw_evolution_energy(Canvas& canvas, const Options& options) {
  std::vector<Curve> curves = read_curves(options);
  if (curves.front().points.size() < 2) {
    fmt::print("no energy: {} has no two times to draw\n",
               (options.directory / "series.csv").string());
    return;
  }
  Range range;
  for (const Curve& curve : curves) range.include(energies_of({curve.points}));
  const double largest = std::max(std::abs(range.low), std::abs(range.high));
  const EnergyScale scale = scale_of(curves, largest);
  const std::vector<Points> points = drawn(curves, scale, range);
  std::vector<LegendEntry> legend;
  for (std::size_t i = 0; i < curves.size(); ++i)
    if (points[i].size() > 1)
      legend.push_back(line_entry(curves[i].part.style, curves[i].part.name));
  const Points fall = above_least(curves.front(), rounding * largest);
  const double text = options.text_size(), width = options.width(1000.0);
  const double legend_at = legend_height(canvas, legend, width - 2.0 * text, text);
  const PanelGrid grid = stacked(fall.empty() ? 1 : 2, 0.8 * text + legend_at, text, options);
  canvas.start(grid.width, grid.height, options.unit());
  const Rect inside = grid.inside(0);
  const HistoryAxes axes = history_axes(points, scale, "energy", inside.height, options);
  Chart chart(canvas, inside, text, axes.time, axes.energy);
  for (std::size_t i = 0; i < curves.size(); ++i) chart.curve(points[i], curves[i].part.style);
  if (!fall.empty())
    draw_fall(canvas, grid.inside(1), fall, curves.front().part, axes.time, options);
  draw_legend(canvas, legend, {text, 0.4 * text, width - 2.0 * text, legend_at}, text);
  canvas.write(options.directory / "energy", options.output());
}

void draw_relaxation_shapes(Canvas& canvas, const Options& options) {
  const std::vector<studies::FrameEntry> frames =
      shown_frames(options.directory / "profiles.csv", options, most_shapes);
  if (frames.empty()) {
    fmt::print("no shapes: {} lists no profile\n", (options.directory / "profiles.csv").string());
    return;
  }
  std::vector<Cut> cuts;
  Extent extent;
  FieldRanges fields;
  for (const studies::FrameEntry& frame : frames) {
    cuts.push_back(mirrored(studies::read_profile(frame.file)));
    extent.include(cuts.back());
    fields.include(cuts.back());
  }
  const CutColours colours = colours_for(fields, options);
  const double text = options.text_size();
  const std::size_t count = cuts.size();
  const std::size_t columns = count <= most_in_a_row ? count : (count + 1) / 2;
  const double right = 3.0 * text + colour_bar_margin(canvas, colours.map, true, text);
  const double margins = text + right;
  const double width = options.width(std::min(1600.0, margins + 360.0 * double(columns)));
  const double cell_width = (width - margins) / double(columns);
  const double title = 3.2 * text;  // with the gap below the row
  std::vector<double> halves;       // largest half height of each row
  for (std::size_t i = 0; i < count; ++i) {
    if (i % columns == 0) halves.push_back(0.0);
    halves.back() = std::max(halves.back(), cuts[i].half_height);
  }
  const double sum = 2.0 * std::accumulate(halves.begin(), halves.end(), 0.0);
  const double fixed = double(halves.size()) * title + text;
  double scale = 0.88 * cell_width / (2.0 * extent.half_width);
  const double room = options.height(fixed + sum * scale) - fixed;
  require_room({0.0, 0.0, cell_width, room}, 3.0 * text, text * double(halves.size()));
  scale = std::min(scale, room / sum);
  const double height = options.height(fixed + sum * scale);

  canvas.start(width, height, options.unit());
  double top = height - 0.5 * (height - fixed - sum * scale) - 0.5 * text;
  for (std::size_t i = 0; i < count; ++i) {
    const double row_height = 2.0 * halves[i / columns] * scale + title;
    const Rect cell{text + double(i % columns) * cell_width, top - row_height, cell_width,
                    row_height - 1.9 * text};
    draw_cuts(canvas, cell, scale,
              {{.cut = &cuts[i], .colours = &colours, .style = {.width = coloured_width}}});
    canvas.text(cell.centre_x(), top - text, time_title(frames[i], options), {.size = text});
    if ((i + 1) % columns == 0) top -= row_height;
  }
  draw_short_bar(canvas, width - right + 1.4 * text, {1.5 * text, height - 1.5 * text}, colours.map,
                 colours.title, text);
  canvas.write(options.directory / "shapes", options.output());
}

}  // namespace sbeh::picture
