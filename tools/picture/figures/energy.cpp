#include "studies/figures/tables.h"
#include "tools/picture/chart/history.h"
#include "tools/picture/chart/legend.h"
#include "tools/picture/figures/figures.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <tuple>

namespace sbeh::picture {

namespace {

constexpr double line_width = 2.4;
constexpr double first_time = 1e-4;  // shown; what is earlier looks like the start

using studies::figures::Solver;

struct History {
  std::vector<double> time, energy;
};

struct Histories {
  using Key = std::tuple<double, double, bool, bool>;  // V_r, L, is SSH, in 3D
  std::map<Key, History> of;
  std::vector<double> volumes, lengths;
  bool sbeh_3d = false, ssh_3d = false;
};

Histories read_histories(const std::filesystem::path& file) {
  Histories all;
  std::set<double> volumes, lengths;
  for (const auto& row : studies::read_rows(studies::figures::energy_columns(), file)) {
    const bool in_3d = row.solver == Solver::in_3d, is_ssh = row.model == model::Model::SSH;
    volumes.insert(row.reduced_volume);
    lengths.insert(row.L);
    (is_ssh ? all.ssh_3d : all.sbeh_3d) |= in_3d;
    History& h = all.of[{row.reduced_volume, row.L, is_ssh, in_3d}];
    if (row.time < first_time) continue;
    h.time.push_back(row.time);
    h.energy.push_back(row.energy);
  }
  all.volumes.assign(volumes.begin(), volumes.end());
  all.lengths.assign(lengths.begin(), lengths.end());
  return all;
}

// So few that the line below can be seen.
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
  std::vector<LegendEntry> entries{
      line_entry({.colour = dark_grey, .width = line_width}, "SBEH"),
      line_entry({.colour = dark_grey, .width = line_width, .dashed = true}, "SSH")};
  if (all.sbeh_3d) entries.push_back(marker_entry(Marker::full, dark_grey, "SBEH in 3D"));
  if (all.ssh_3d) entries.push_back(marker_entry(Marker::hollow, dark_grey, "SSH in 3D"));
  for (std::size_t l = 0; l < all.lengths.size(); ++l)
    entries.push_back(
        line_entry({.colour = colours[l], .width = 2 * line_width}, length_title(all.lengths[l])));
  return entries;
}

}  // namespace

void draw_figure_energy(Canvas& canvas, const Options& options) {
  const Histories all = read_histories(options.directory / "energy.csv");
  const std::vector<Colour> colours = line_colours(all.lengths.size());
  std::vector<Points> points;
  for (const auto& [key, h] : all.of)
    points.push_back(log_log(h.time, h.energy, options.energy_shift));
  const HistoryAxes axes = history_axes(points, options.energy_name());
  const auto legend = legend_of(all, colours);

  const double text = options.text_size();
  const auto columns = double(all.volumes.size());
  const double width = options.size ? options.size->width : 1600.0;
  const double left = 5.6 * text, gap = 2.0 * text;
  const double inner_width = (width - left - gap * columns) / columns;
  const double legend_at = legend_height(canvas, legend, width - 2.0 * text, text);
  const double below = legend_at + 0.8 * text + below_axis(text), above = 2.4 * text;
  const double height = options.size ? options.size->height : below + above + 1.1 * inner_width;
  canvas.start(width, height);
  for (std::size_t panel = 0; panel < all.volumes.size(); ++panel) {
    const Rect inside{left + double(panel) * (inner_width + gap), below, inner_width,
                      height - below - above};
    Axis energy = axes.energy;
    if (panel > 0) {
      energy.title.clear();
      std::ranges::fill(energy.labels, "");
    }
    Chart chart(canvas, inside, text, axes.time, energy);
    for (const auto& [key, h] : all.of) {
      const auto& [volume, length, is_ssh, in_3d] = key;
      if (volume != all.volumes[panel]) continue;
      const Colour colour =
          colours[std::size_t(std::ranges::find(all.lengths, length) - all.lengths.begin())];
      const Points curve = log_log(h.time, h.energy, options.energy_shift);
      if (in_3d)
        chart.markers(thinned(curve), is_ssh ? Marker::hollow : Marker::full, colour, 0.45 * text);
      else
        chart.curve(curve, {.colour = colour, .width = line_width, .dashed = is_ssh});
    }
    canvas.text(inside.centre_x(), inside.top() + 1.0 * text, volume_title(all.volumes[panel]),
                {.size = text});
  }
  draw_legend(canvas, legend, {text, 0.4 * text, width - 2.0 * text, legend_at}, text);
  canvas.write(options.directory / "energy");
}

}  // namespace sbeh::picture
