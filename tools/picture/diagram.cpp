#include "tools/picture/diagram.h"

#include "tools/picture/heat_map.h"
#include "tools/picture/line_diagram.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace sbeh::picture {
namespace {

constexpr std::size_t most_table_cells = 30;

std::vector<Quantity> quantities_of(const ScanTable& scan) {
  if (!scan.has(Model::SBEH)) {
    fmt::print("diagram: no SBEH rows, so neither energy gap nor smallest order\n");
    return {energy(scan, Model::SSH), largest_curvature(scan, Model::SSH)};
  }
  if (!scan.has(Model::SSH)) {
    fmt::print("diagram: no SSH rows, so the energy itself in place of the energy gap\n");
    return {energy(scan, Model::SBEH), smallest_order(scan), largest_curvature(scan, Model::SBEH)};
  }
  return {energy_gap(scan), smallest_order(scan), largest_curvature(scan, Model::SBEH)};
}

void draw_heat_maps(Canvas& canvas, const ScanTable& scan, const Options& options) {
  const std::vector<Quantity> quantities = quantities_of(scan);
  const double text = options.text_size();
  const bool as_table = scan.reduced_volumes().size() * scan.lengths().size() <= most_table_cells;
  const auto legend = mark_legend(quantities, as_table);
  std::vector<ColourMap> colours;
  double bars = 0.0;  // the width that all bars take with their numbers
  for (const Quantity& quantity : quantities) {
    const auto [low, high] = quantity.range();
    colours.emplace_back(Palette::viridis, low, high);
    bars += 1.7 * text + colour_bar_margin(canvas, colours.back(), false, text);
  }
  const auto count = double(quantities.size());
  const double width = options.size ? options.size->width : 533.0 * count;
  const double left = 5.2 * text, gap = 1.8 * text;
  const double inner_width = (width - left - bars - gap * count) / count;
  const double legend_at = legend_height(canvas, legend, width - 2.0 * text, text);
  const double below = below_axis(text) + (legend.empty() ? 0.0 : 0.8 * text + legend_at),
               above = 2.6 * text;
  const double height = options.size ? options.size->height : below + above + 1.15 * inner_width;
  const double inner_height = height - below - above;

  HeatMapGrid grid{.x = {}, .y = {}, .as_table = as_table};
  grid.x = as_table
             ? table_axis(scan.reduced_volumes(), "reduced volume Vᵣ")
             : distance_axis(scan.reduced_volumes(), "reduced volume Vᵣ", inner_width, 3.2 * text);
  grid.y = as_table ? table_axis(scan.lengths(), "elastic constant L")
                    : distance_axis(scan.lengths(), "elastic constant L", inner_height, 3.0 * text);

  canvas.start(width, height);
  double x = left;
  for (std::size_t i = 0; i < quantities.size(); ++i) {
    const Rect inside{x, below, inner_width, inner_height};
    draw_heat_map(canvas, inside, quantities[i], colours[i], grid, text);
    canvas.text(inside.centre_x(), inside.top() + 1.2 * text, quantities[i].title, {.size = text});
    x += inner_width + 1.7 * text + colour_bar_margin(canvas, colours[i], false, text) + gap;
    grid.y.axis.title.clear();
    std::ranges::fill(grid.y.axis.labels, "");
  }
  draw_legend(canvas, legend, {text, 0.4 * text, width - 2.0 * text, legend_at}, text);
  canvas.write(options.directory / "diagram");
}

}  // namespace

void draw_diagram_picture(Canvas& canvas, const ScanTable& scan, const Options& options) {
  const bool one_volume = scan.reduced_volumes().size() == 1;
  const bool one_length = scan.lengths().size() == 1;
  if (one_volume != one_length) {
    draw_line_diagram(canvas, scan, options);
  } else {
    draw_heat_maps(canvas, scan, options);
  }
}

}  // namespace sbeh::picture
