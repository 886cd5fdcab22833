#include "axisym/curve.h"
#include "tools/picture/modes/modes.h"
#include "tools/picture/modes/shown_modes.h"

#include <algorithm>
#include <cmath>

namespace sbeh::picture {
namespace {

constexpr double tallest = 1.3;  // a shape, in widths of its cell

// A closed curve in the plane φ = 0, its last point the first, with a value at each point.
struct Curve {
  Points points;
  std::vector<double> values;
};

Curve cut_of(const ShownModes& all, const studies::StateMode& mode, double amplitude) {
  const axisym::Nodes n = axisym::node_normals(mode.state.X);
  const double other_side = mode.key.m % 2 == 0 ? 1.0 : -1.0;  // cos mπ
  const axisym::Field values = all.field(mode) / all.largest(mode);
  Curve curve;
  const auto add = [&](Eigen::Index i, double side, double wave) {
    const Eigen::Vector2d x = mode.state.X.col(i) + amplitude * wave * mode.u[i] * n.col(i);
    curve.points.push_back({side * x[0], x[1]});
    curve.values.push_back(wave * values[i]);
  };
  const Eigen::Index count = mode.u.size();
  for (Eigen::Index i = 0; i < count; ++i) add(i, 1.0, 1.0);
  for (Eigen::Index i = count - 1; i-- > 0;) add(i, -1.0, other_side);
  return curve;
}

// Of all curves, about the middle of the state.
struct Extent {
  double across = 0.0, up = 0.0;
};
Extent extent_of(const ShownModes& all) {
  Extent extent;
  const Eigen::Matrix2Xd& X = all.modes.front().mode.state.X;
  constexpr double room = 1.2 * shown_amplitude;  // with that of the lines
  extent.across = X.row(0).maxCoeff() + room;
  extent.up = 0.5 * (X.row(1).maxCoeff() - X.row(1).minCoeff()) + room;
  return extent;
}

void draw_cell(Canvas& canvas, const Rect& cell, double scale, const ShownModes& all,
               const studies::StateMode& mode) {
  const auto z = mode.state.X.row(1);
  const double middle = 0.5 * (z.maxCoeff() + z.minCoeff());
  const double across = 0.5 * cell.width / scale, up = 0.5 * cell.height / scale;
  Chart chart(canvas, cell, 1.0, {.low = -across, .high = across},
              {.low = middle - up, .high = middle + up});
  chart.curve(cut_of(all, mode, 0.0).points, {.colour = {150, 150, 150}, .width = 2.0});
  const Curve moved = cut_of(all, mode, amplitude_of(mode));
  std::vector<Colour> colours;
  for (const double value : moved.values) colours.push_back(all.colours(value));
  chart.coloured_curve(moved.points, colours, 5.0);
}

}  // namespace

void draw_mode_profiles(Canvas& canvas, const Options& options) {
  const ShownModes all(options);
  const double text = options.text_size();
  const auto columns = double(all.columns), rows = double(all.rows);
  const double right = 3.0 * text + colour_bar_margin(canvas, all.colours, true, text);
  const double words = height_of_words(all, text), gap = 0.8 * text;
  const double width = options.width(right + text + 270.0 * columns);
  const double cell_width = (width - right - text) / columns;
  const Extent extent = extent_of(all);
  double scale = cell_width * std::min(0.94 / (2.0 * extent.across), tallest / (2.0 * extent.up));
  const double fixed = rows * (words + gap) + text;
  const double room = options.height(fixed + rows * 2.0 * extent.up * scale) - fixed;
  require_room({0.0, 0.0, cell_width, room}, 3.0 * text, 2.0 * text * rows);
  scale = std::min(scale, room / (rows * 2.0 * extent.up));
  const double height = options.height(fixed + rows * 2.0 * extent.up * scale);
  const double row_height = (height - text) / rows;
  canvas.start(width, height, options.unit());
  for (const ShownMode& one : all.modes) {
    const Rect cell{text + double(one.column) * cell_width,
                    height - 0.5 * text - double(one.row + 1) * row_height + gap, cell_width,
                    row_height - gap};
    draw_words(canvas, cell, all, one.mode, text);
    draw_cell(canvas, {cell.x, cell.y, cell.width, cell.height - words}, scale, all, one.mode);
  }
  draw_short_bar(canvas, width - right + 1.4 * text, {1.5 * text, height - 1.5 * text}, all.colours,
                 all.title(), text);
  canvas.write(options.directory / "profiles", options.output());
}

}  // namespace sbeh::picture
