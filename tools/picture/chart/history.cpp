#include "tools/picture/chart/history.h"

#include "tools/picture/chart/legend.h"
#include "tools/picture/chart/panels.h"

#include <algorithm>
#include <cmath>

namespace sbeh::picture {
namespace {

constexpr double line_width = 2.4;

// So few marks that the line below can be seen, `distance` decades apart.
Points thinned(const Points& points, double distance) {
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
  const LineStyle dashed{.colour = dark_grey, .width = line_width, .pattern = Pattern::dashed};
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

Points over_time(const std::vector<double>& time, const std::vector<double>& value, double shift) {
  constexpr double shown = 1e-6;  // of the last time: what is earlier looks like the start
  const double first = time.empty() ? 0.0 : shown * time.back();
  Points points;
  for (std::size_t i = 0; i < time.size(); ++i)
    if (time[i] > 0.0 && time[i] >= first && std::isfinite(value[i]))
      points.push_back({std::log10(time[i]), value[i] + shift});
  return points;
}

EnergyScale scale_for(const std::vector<Points>& curves) {
  for (const Points& curve : curves)
    for (const auto& point : curve)
      if (!(point[1] > 0.0)) return EnergyScale::linear;
  return EnergyScale::logarithmic;
}

Points on_scale(const Points& curve, EnergyScale scale, double height, double floor) {
  constexpr double decades = 0.004, share = 0.002;  // what is told apart
  const bool logarithmic = scale == EnergyScale::logarithmic;
  const double resolution = logarithmic ? decades : share * height;
  Points shown;
  for (std::size_t i = 0; i < curve.size(); ++i) {
    const double x = curve[i][0], y = logarithmic ? std::log10(curve[i][1]) : curve[i][1];
    if (!std::isfinite(y) || (logarithmic && y < floor)) continue;
    const bool new_place = shown.empty() || std::abs(x - shown.back()[0]) > decades
                        || std::abs(y - shown.back()[1]) > resolution;
    if (new_place || i + 1 == curve.size()) shown.push_back({x, y});
  }
  return shown;
}

HistoryAxes history_axes(const std::vector<Points>& curves, EnergyScale scale,
                         const std::string& energy_name, double length, const Options& options) {
  Range time, energy;
  for (const Points& curve : curves)
    for (const auto& point : curve) {
      time.include(point[0]);
      energy.include(point[1]);
    }
  const double margin = 0.04 * energy.width();
  const double low = energy.low - margin, high = energy.high + margin;
  const std::string name = options.titled(energy_name, studies::dimension::energy);
  return {decade_axis(time.low, time.high, options.titled("t", studies::dimension::time)),
          scale == EnergyScale::logarithmic
              ? decade_axis(low, high, name)
              : exact_axis(low, high, length, 3.0 * options.text_size(), name)};
}

Range energies_of(const std::vector<Points>& curves) {
  Range range;
  for (const Points& curve : curves)
    for (const auto& point : curve) range.include(point[1]);
  return range;
}

void draw_histories(Canvas& canvas, const Options& options, const Histories& all,
                    const HistoryLayout& layout) {
  const std::vector<Colour> colours = line_colours(all.lengths.size());
  std::vector<Points> points;
  for (const Histories::Curve& curve : all.curves) points.push_back(curve.points);
  const EnergyScale scale = scale_for(points);
  const double energies = energies_of(points).width();
  for (Points& curve : points) curve = on_scale(curve, scale, energies);
  const auto legend = legend_of(all, colours);

  const double text = options.text_size();
  const double legend_at =
      legend_height(canvas, legend, options.width(layout.width) - 2.0 * text, text);
  const PanelGrid grid = arranged({.count = all.reduced_volumes.size(),
                                   .most_columns = layout.columns,
                                   .usual_width = layout.width / double(layout.columns),
                                   .least_width = 9.0 * text,
                                   .height_by_width = layout.height_by_width,
                                   .side = 5.6 * text,
                                   .right = layout.gap * text,
                                   .below = below_axis(text),
                                   .above = 2.4 * text,
                                   .bottom = legend_at + layout.above_legend * text},
                                  options);
  const HistoryAxes axes =
      history_axes(points, scale, options.energy_name(), grid.inner_height, options);
  const double marks =
      std::max(0.25, 1.2 * text / grid.inner_width * (axes.time.high - axes.time.low));
  canvas.start(grid.width, grid.height, options.unit());
  for (std::size_t panel = 0; panel < all.reduced_volumes.size(); ++panel) {
    const Rect inside = grid.inside(panel);
    Axis energy = axes.energy;
    if (!grid.begins_row(panel)) {
      energy.title.clear();
      std::ranges::fill(energy.labels, "");
    }
    Chart chart(canvas, inside, text, axes.time, energy);
    for (std::size_t i = 0; i < all.curves.size(); ++i) {
      const Histories::Curve& curve = all.curves[i];
      if (curve.reduced_volume != all.reduced_volumes[panel]) continue;
      const auto length = std::ranges::find(all.lengths, curve.L) - all.lengths.begin();
      const Colour colour = colours[std::size_t(length)];
      if (curve.in_3d)
        chart.markers(thinned(points[i], marks), curve.is_ssh ? Marker::hollow : Marker::full,
                      colour, 0.45 * text);
      else
        chart.curve(points[i], {.colour = colour,
                                .width = line_width,
                                .pattern = curve.is_ssh ? Pattern::dashed : Pattern::solid});
    }
    canvas.text(inside.centre_x(), inside.top() + 1.0 * text,
                volume_title(all.reduced_volumes[panel]), {.size = text});
  }
  draw_legend(canvas, legend, {text, 0.4 * text, grid.width - 2.0 * text, legend_at}, text);
  canvas.write(options.directory / "energy", options.output());
}

}  // namespace sbeh::picture
