#include "studies/figures/tables.h"
#include "tools/picture/chart/legend.h"
#include "tools/picture/figures/figures.h"
#include "tools/picture/section/cut.h"
#include "tools/picture/surface/frames.h"
#include "tools/picture/surface/scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>

namespace sbeh::picture {
namespace {

const View from_the_side{{0.35, -1.0, 0.55}, {0, 0, 1}};
constexpr double flatness = 0.72;  // height of a cell by its width: what an oblate needs, seen so

using Point = std::pair<double, double>;  // V_r, L

struct Stationary {
  std::vector<double> volumes, lengths;
  std::map<Point, studies::CurvedFile> in_3d;
  std::map<Point, std::string> lacks;  // what there is instead of a shape in 3D
  std::map<Point, Cut> sbeh;
  std::map<double, Cut> ssh;       // by V_r: the same for all L
  bool axisymmetric_cuts = false;  // of SBEH, where there is no 3D run
  double half_width = 0;
  Range orders;
  Extent extent;
};

void read_shapes(const std::filesystem::path& folder, Stationary& all) {
  std::set<double> volumes, lengths;
  for (const auto& row :
       studies::read_rows(studies::figures::shape_columns(), folder / "shapes.csv")) {
    volumes.insert(row.reduced_volume);
    lengths.insert(row.L);
    if (!row.in_3d) {
      all.lacks[{row.reduced_volume, row.L}] = row.lacks;
      continue;
    }
    studies::CurvedFile& state = all.in_3d[{row.reduced_volume, row.L}] =
        read_state(folder / row.in_3d->frame);
    all.half_width = std::max(all.half_width, 1.12 * radius_of(state.mesh));
    all.orders.include(state.fields.at("order").minCoeff());
    all.orders.include(state.fields.at("order").maxCoeff());
  }
  all.volumes.assign(volumes.begin(), volumes.end());
  all.lengths.assign(lengths.begin(), lengths.end());
}

void read_cuts(const std::filesystem::path& file, Stationary& all) {
  for (const auto& row : studies::read_rows(studies::figures::cut_columns(), file)) {
    const bool is_ssh = row.model == model::Model::SSH;
    if (is_ssh && row.L != all.lengths.front()) continue;
    all.axisymmetric_cuts =
        all.axisymmetric_cuts || (!is_ssh && row.solver == studies::figures::Solver::axisymmetric);
    Cut& cut = is_ssh ? all.ssh[row.reduced_volume] : all.sbeh[{row.reduced_volume, row.L}];
    cut.points.push_back({row.x, row.z});
    cut.order.push_back(row.order);
    cut.half_width = std::max(cut.half_width, std::abs(row.x));
    cut.half_height = std::max(cut.half_height, std::abs(row.z));
  }
  for (const auto& [point, cut] : all.sbeh) all.extent.include(cut);
  for (const auto& [point, cut] : all.ssh) all.extent.include(cut);
}

const LineStyle ssh_style{.colour = red, .width = 1.8, .pattern = Pattern::dashed};

std::vector<LegendEntry> legend_of(const Stationary& all) {
  const std::size_t count = all.lengths.size();
  const bool some_in_3d = !all.in_3d.empty();
  const char* others =
      some_in_3d && all.axisymmetric_cuts ? " (axisymmetric without a shape in 3D)" : "";
  return {
      line_entry(style_by_length(0, count), fmt::format("SBEH{}, {}", some_in_3d ? " in 3D" : "",
                                                        length_title(all.lengths.front()))),
      line_entry(style_by_length(count - 1, count),
                 "to " + length_title(all.lengths.back()) + others),
      line_entry(ssh_style, "SSH")};
}

void draw_cut_cell(Canvas& canvas, const Stationary& all, double volume, const Rect& cell,
                   double scale) {
  std::vector<CutLine> lines;
  for (std::size_t l = 0; l < all.lengths.size(); ++l)
    if (const auto cut = all.sbeh.find({volume, all.lengths[l]}); cut != all.sbeh.end())
      lines.push_back({.cut = &cut->second, .style = style_by_length(l, all.lengths.size())});
  if (const auto cut = all.ssh.find(volume); cut != all.ssh.end())
    lines.push_back({.cut = &cut->second, .style = ssh_style});
  if (!lines.empty()) draw_cuts(canvas, cell, scale, lines);
}

// In the place of a shape; where there is no room for the reason, without it.
void draw_words(Canvas& canvas, const Rect& cell, const std::string& reason, double text) {
  const double size = 0.8 * text, room = 0.94 * cell.width, line = 1.3;
  const auto broken = [&](const std::string& words) { return in_lines(canvas, words, room, size); };
  std::vector<std::string> lines = broken("no shape in 3D: " + reason);
  if (line * double(lines.size()) * size > cell.height) lines = broken("no shape in 3D");
  const double fitted = fitted_size(canvas, lines, room, size);
  for (std::size_t k = 0; k < lines.size(); ++k)
    canvas.text(cell.centre_x(),
                cell.centre_y() + line * size * (0.5 * double(lines.size() - 1) - double(k)),
                lines[k], {.size = fitted, .colour = dark_grey});
}

void draw_shape_cell(Canvas& canvas, const Stationary& all, const Point& point, const Rect& cell,
                     const std::optional<ColourMap>& colours, const View& view, double text) {
  const auto state = all.in_3d.find(point);
  if (state == all.in_3d.end()) {
    const auto lacks = all.lacks.find(point);
    draw_words(canvas, cell, lacks == all.lacks.end() ? "" : lacks->second, text);
    return;
  }
  draw_surface(canvas, cell, state->second.mesh,
               state->second.fields.at("order").row(0).transpose(), *colours, view, all.half_width);
}

}  // namespace

void draw_figure_shapes(Canvas& canvas, const Options& options) {
  Stationary all;
  read_shapes(options.directory, all);
  read_cuts(options.directory / "cuts.csv", all);
  if (!all.lacks.empty())
    fmt::print("shapes: {} of {} are drawn in 3D\n", all.in_3d.size(),
               all.in_3d.size() + all.lacks.size());
  std::optional<ColourMap> colours;
  if (!all.in_3d.empty())
    colours = chosen_colours(options, order_palette, all.orders, white_on_surfaces);

  const double text = options.text_size();
  const double left = canvas.text_width(volume_title(0.65), text) + 1.8 * text;
  const double right =
      2.0 * text + (colours ? 1.6 * text + colour_bar_margin(canvas, *colours, true, text) : 0.0);
  const auto columns = double(all.lengths.size()), rows = double(all.volumes.size());
  const double width = options.width(left + right + 300.0 * columns);
  const double side = std::floor((width - left - right) / columns);
  const double cell_height = std::floor(flatness * side);
  const auto legend = legend_of(all);
  const double legend_at = legend_height(canvas, legend, width - 2.0 * text, text);
  const double cut_width = side * columns / rows;
  const double scale = 0.42 * cut_width / all.extent.half_width;
  const double cut_height = 2.2 * all.extent.half_height * scale;
  const double head = 2.2 * text, below = legend_at + 0.8 * text, between = 2.6 * text;
  const double height = options.height(head + rows * cell_height + between + cut_height + below);
  canvas.start(width, height, options.unit());
  std::vector<std::string> titles;
  for (const double L : all.lengths) titles.push_back(length_title(L));
  const double title_size = fitted_size(canvas, titles, 0.9 * side, text);
  for (std::size_t l = 0; l < titles.size(); ++l)
    canvas.text(left + (double(l) + 0.5) * side, height - 1.2 * text, titles[l],
                {.size = title_size});
  for (std::size_t v = 0; v < all.volumes.size(); ++v) {
    const double y = height - head - double(v + 1) * cell_height;
    canvas.text(left - 0.8 * text, y + 0.5 * cell_height, volume_title(all.volumes[v]),
                {.size = text, .align = Align::right});
    for (std::size_t l = 0; l < all.lengths.size(); ++l)
      draw_shape_cell(canvas, all, {all.volumes[v], all.lengths[l]},
                      {left + double(l) * side, y, side, cell_height}, colours,
                      options.views_or({from_the_side}).front(), text);
    const Rect cut{left + double(v) * cut_width, below, cut_width, cut_height};
    draw_cut_cell(canvas, all, all.volumes[v], cut, scale);
    canvas.text(cut.centre_x(), cut.top() + 0.9 * text, volume_title(all.volumes[v]),
                {.size = text});
  }
  if (colours)
    draw_short_bar(canvas, width - right + 1.2 * text,
                   {height - head - rows * cell_height, height - head}, *colours, "order β", text);
  draw_legend(canvas, legend, {text, 0.4 * text, width - 2.0 * text, legend_at}, text);
  canvas.write(options.directory / "shapes", options.output());
}

}  // namespace sbeh::picture
