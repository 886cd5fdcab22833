#include "tools/picture/modes/modes.h"
#include "tools/picture/modes/shown_modes.h"
#include "tools/picture/surface/scene.h"

#include <algorithm>
#include <cmath>

namespace sbeh::picture {
namespace {

constexpr int triangles = 720;

// So that waves about the axis are seen.
const View from_above{{0.6, -1.0, 0.95}, {0, 0, 1}};

// A displaced surface with what it is coloured by, −1 … 1.
struct Displaced {
  meshing::CurvedMesh mesh;
  Eigen::VectorXd values;
};

Displaced displaced(const ShownModes& all, const studies::StateMode& mode) {
  studies::RevolvedMode surface = studies::revolved(mode, {.triangles = triangles});
  surface.mesh.nodes += amplitude_of(mode) * surface.displacement;
  const Eigen::VectorXd& values = all.by_order ? surface.order_change : surface.along_normal;
  return {std::move(surface.mesh), values / all.largest(mode)};
}

}  // namespace

void draw_mode_surfaces(Canvas& canvas, const Options& options) {
  const ShownModes all(options);
  const ColourMap colours =
      chosen_colours(options, Palette::cividis, {-1.0, 1.0}, white_on_surfaces);
  std::vector<Displaced> surfaces;
  double half_width = 0.0;
  for (const ShownMode& one : all.modes) {
    surfaces.push_back(displaced(all, one.mode));
    half_width = std::max(half_width, 1.03 * radius_of(surfaces.back().mesh));
  }
  const double text = options.text_size();
  const auto columns = double(all.columns), rows = double(all.rows);
  const double right = 3.0 * text + colour_bar_margin(canvas, colours, true, text);
  const std::vector<View> views = options.views_or({from_above});
  const auto high = double(views.size());
  const double words = height_of_words(all, text);
  const double width = options.width(right + text + 270.0 * columns);
  const double cell_width = std::floor((width - right - text) / columns);
  const double height = options.height(rows * (words + high * cell_width) + text);
  const double row_height = (height - text) / rows;
  const double side = std::floor(std::min(cell_width, (row_height - words) / high));
  canvas.start(width, height, options.unit());
  for (std::size_t i = 0; i < all.modes.size(); ++i) {
    const ShownMode& one = all.modes[i];
    const Rect cell{text + double(one.column) * cell_width,
                    height - 0.5 * text - double(one.row + 1) * row_height, cell_width, row_height};
    draw_words(canvas, cell, all, one.mode, text);
    double top = cell.top() - words;
    for (const View& view : views) {
      top -= side;
      draw_surface(canvas, {std::floor(cell.centre_x() - side / 2), std::floor(top), side, side},
                   surfaces[i].mesh, surfaces[i].values, colours, view, half_width);
    }
  }
  draw_short_bar(canvas, width - right + 1.4 * text, {1.5 * text, height - 1.5 * text}, colours,
                 all.title(), text);
  canvas.write(options.directory / "surfaces", options.output({Format::png}));
}

}  // namespace sbeh::picture
