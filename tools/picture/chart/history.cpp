#include "tools/picture/chart/history.h"

#include "tools/picture/chart/legend.h"

#include <algorithm>
#include <cmath>

namespace sbeh::picture {
namespace {

constexpr double line_width = 2.4;

// So few marks that the line below can be seen.
Points thinned(const Points& points) {
  constexpr double distance = 0.25;  // decades
  Points kept;
  double last = points.empty() ? 0.0 : points.front()[0];  // at the edge a marker would be cut
  for (const auto& point : points) {
    if (point[0] - last <= distance) continue;
    kept.push_back(point);
    last = point[0];
  }
  return kept;
}

std::vector<LegendEntry> legend_of(const Histories& all, const std::vector<Colour>& colours) {
  const LineStyle line{.colour = dark_grey, .width = line_width};
  const LineStyle dashed{.colour = dark_grey, .width = line_width, .dashed = true};
  std::vector<LegendEntry> entries;
  if (all.sbeh) entries.push_back(line_entry(line, "SBEH"));
  if (all.ssh) entries.push_back(line_entry(dashed, "SSH"));
  if (all.sbeh_3d) entries.push_back(marker_entry(Marker::full, dark_grey, "SBEH in 3D"));
  if (all.ssh_3d) entries.push_back(marker_entry(Marker::hollow, dark_grey, "SSH in 3D"));
  for (std::size_t l = 0; l < all.lengths.size(); ++l)
    entries.push_back(line_entry({.colour = colours[l], .width = 2.0 * line_width},
                                 length_title(all.lengths[l])));
  return entries;
}

}  // namespace

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

HistoryAxes history_axes(const std::vector<Points>& curves, const std::string& energy_name) {
  Range time, energy;
  for (const Points& curve : curves)
    for (const auto& point : curve) {
      time.include(point[0]);
      energy.include(point[1]);
    }
  const double margin = 0.04 * energy.width();
  return {decade_axis(time.low, time.high, "t"),
          decade_axis(energy.low - margin, energy.high + margin, energy_name)};
}

void draw_histories(Canvas& canvas, const Options& options, const Histories& all,
                    const HistoryLayout& layout) {
  const std::vector<Colour> colours = line_colours(all.lengths.size());
  std::vector<Points> points;
  for (const Histories::Curve& curve : all.curves) points.push_back(curve.points);
  const HistoryAxes axes = history_axes(points, options.energy_name());
  const auto legend = legend_of(all, colours);

  const double text = options.text_size();
  const std::size_t count = all.reduced_volumes.size();
  const auto columns = double(layout.columns), rows = std::ceil(double(count) / columns);
  const double width = options.width(layout.width);
  const double left = 5.6 * text, gap = layout.gap * text;
  const double inner_width = (width - left - gap * columns) / columns;
  const double legend_at = legend_height(canvas, legend, width - 2.0 * text, text);
  const double foot = legend_at + layout.above_legend * text;
  const double below = below_axis(text), above = 2.4 * text;  // of each row
  const double height =
      options.height(foot + rows * (below + above + layout.height_by_width * inner_width));
  const double row_height = (height - foot) / rows;
  canvas.start(width, height);
  for (std::size_t panel = 0; panel < count; ++panel) {
    const std::size_t column = panel % layout.columns, row = panel / layout.columns;
    const Rect inside{left + double(column) * (inner_width + gap),
                      height - double(row + 1) * row_height + below, inner_width,
                      row_height - below - above};
    Axis energy = axes.energy;
    if (column != 0) {
      energy.title.clear();
      std::ranges::fill(energy.labels, "");
    }
    Chart chart(canvas, inside, text, axes.time, energy);
    for (const Histories::Curve& curve : all.curves) {
      if (curve.reduced_volume != all.reduced_volumes[panel]) continue;
      const auto length = std::ranges::find(all.lengths, curve.L) - all.lengths.begin();
      const Colour colour = colours[std::size_t(length)];
      if (curve.in_3d)
        chart.markers(thinned(curve.points), curve.is_ssh ? Marker::hollow : Marker::full, colour,
                      0.45 * text);
      else
        chart.curve(curve.points, {.colour = colour, .width = line_width, .dashed = curve.is_ssh});
    }
    canvas.text(inside.centre_x(), inside.top() + 1.0 * text,
                volume_title(all.reduced_volumes[panel]), {.size = text});
  }
  draw_legend(canvas, legend, {text, 0.4 * text, width - 2.0 * text, legend_at}, text);
  canvas.write(options.directory / "energy");
}

}  // namespace sbeh::picture
