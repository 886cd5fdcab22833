#include "tools/picture/scan/energy.h"

#include "tools/picture/chart/history.h"
#include "tools/picture/chart/legend.h"

#include <fmt/format.h>

#include <algorithm>

namespace sbeh::picture {
namespace {

constexpr std::size_t most_panels = 6;
constexpr std::size_t most_lengths = 8;
constexpr double line_width = 2.4;

struct Curve {
  std::size_t panel;
  Points points;
  LineStyle style;
};

struct Histories {
  std::vector<std::size_t> volumes;
  std::vector<std::size_t> lengths;
  std::vector<Colour> colours;  // of the lengths
  std::vector<Curve> curves;
};

Histories read_histories(const ScanGrid& scan, const Options& options) {
  Histories all{.volumes = evenly_spread(scan.reduced_volumes().size(), most_panels),
                .lengths = evenly_spread(scan.lengths().size(), most_lengths),
                .colours = {},
                .curves = {}};
  all.colours = line_colours(all.lengths.size());
  for (std::size_t panel = 0; panel < all.volumes.size(); ++panel) {
    for (std::size_t l = 0; l < all.lengths.size(); ++l) {
      for (const Model model : {Model::SBEH, Model::SSH}) {
        const PointResult* point = scan.find(model, all.volumes[panel], all.lengths[l]);
        if (!point || !std::filesystem::exists(scan.series(*point))) continue;
        Points points = energy_over_time(scan.series(*point), options.energy_shift);
        if (points.size() < 2) continue;
        const LineStyle style{
            .colour = all.colours[l], .width = line_width, .dashed = model == Model::SSH};
        all.curves.push_back({panel, std::move(points), style});
      }
    }
  }
  return all;
}

bool any_series(const ScanGrid& scan) {
  for (std::size_t v = 0; v < scan.reduced_volumes().size(); ++v) {
    for (std::size_t l = 0; l < scan.lengths().size(); ++l) {
      for (const Model model : {Model::SBEH, Model::SSH}) {
        const PointResult* point = scan.find(model, v, l);
        if (point && std::filesystem::exists(scan.series(*point))) return true;
      }
    }
  }
  return false;
}

std::vector<LegendEntry> legend_of(const ScanGrid& scan, const Histories& all) {
  std::vector<LegendEntry> entries;
  if (scan.has(Model::SBEH)) {
    entries.push_back(line_entry({.colour = dark_grey, .width = line_width}, "SBEH"));
  }
  if (scan.has(Model::SSH)) {
    entries.push_back(
        line_entry({.colour = dark_grey, .width = line_width, .dashed = true}, "SSH"));
  }
  for (std::size_t l = 0; l < all.lengths.size(); ++l) {
    entries.push_back(line_entry({.colour = all.colours[l], .width = 2.0 * line_width},
                                 length_title(scan.lengths()[all.lengths[l]])));
  }
  return entries;
}

}  // namespace

void draw_energy_picture(Canvas& canvas, const ScanGrid& scan, const Options& options) {
  if (!any_series(scan)) {
    if (!options.only.empty()) fmt::print("no energy: the scan has left no energies over time\n");
    return;
  }
  const Histories all = read_histories(scan, options);
  if (all.curves.empty()) {
    fmt::print("no energy: {} is positive nowhere; set --energy-shift\n", options.energy_name());
    return;
  }
  std::vector<Points> points;
  for (const Curve& curve : all.curves) points.push_back(curve.points);
  const HistoryAxes axes = history_axes(points, options.energy_name());

  const auto legend = legend_of(scan, all);
  const double text = options.text_size();
  const std::size_t count = all.volumes.size();
  const std::size_t columns = count == 4 ? 2 : std::min<std::size_t>(count, 3);
  const std::size_t rows = (count + columns - 1) / columns;
  const double width = options.size ? options.size->width : columns == 1 ? 900.0 : 1600.0;
  const double left = 5.6 * text, gap = 2.6 * text;
  const double inner_width = (width - left - gap * double(columns)) / double(columns);
  const double legend_at = legend_height(canvas, legend, width - 2.0 * text, text);
  const double below = below_axis(text), above = 2.4 * text;  // of each row
  const double height =
      options.size ? options.size->height
                   : legend_at + 0.6 * text + double(rows) * (below + above + 0.85 * inner_width);
  const double row_height = (height - legend_at - 0.6 * text) / double(rows);

  canvas.start(width, height);
  for (std::size_t panel = 0; panel < count; ++panel) {
    const auto column = double(panel % columns), row = double(panel / columns);
    const Rect inside{left + column * (inner_width + gap),
                      height - (row + 1.0) * row_height + below, inner_width,
                      row_height - below - above};
    Axis energy = axes.energy;
    if (panel % columns != 0) {
      energy.title.clear();
      std::ranges::fill(energy.labels, "");
    }
    Chart chart(canvas, inside, text, axes.time, energy);
    for (const Curve& curve : all.curves) {
      if (curve.panel == panel) chart.curve(curve.points, curve.style);
    }
    canvas.text(inside.centre_x(), inside.top() + 1.0 * text,
                volume_title(scan.reduced_volumes()[all.volumes[panel]]), {.size = text});
  }
  draw_legend(canvas, legend, {text, 0.4 * text, width - 2.0 * text, legend_at}, text);
  canvas.write(options.directory / "energy");
}

}  // namespace sbeh::picture
