#include "tools/picture/evolution/evolution.h"
#include "tools/picture/surface/frames.h"
#include "tools/picture/surface/scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace sbeh::picture {
namespace {

constexpr std::size_t most_shapes = 10, most_in_a_row = 5;

struct Shown {
  std::vector<studies::CurvedFile> states;
  Field field;
  Range range;
};

Range range_of(const std::vector<studies::CurvedFile>& states, Field field) {
  std::vector<double> values;
  for (const auto& state : states) {
    const Eigen::VectorXd of_state = field_of(state, field);
    values.insert(values.end(), of_state.begin(), of_state.end());
  }
  return shown_range(std::move(values), field);
}

Shown read_states(const std::vector<studies::FrameEntry>& frames, const Options& options) {
  Shown shown;
  for (const studies::FrameEntry& frame : frames) shown.states.push_back(read_state(frame.file));
  shown.field = options.field_for(range_of(shown.states, Field::order));
  shown.range = range_of(shown.states, shown.field);
  return shown;
}

}  // namespace

void draw_run_shapes(Canvas& canvas, const Options& options) {
  const std::vector<studies::FrameEntry> frames =
      shown_frames(options.directory / "frames.csv", options, most_shapes);
  if (frames.empty()) {
    fmt::print("no shapes: {} lists no frame\n", (options.directory / "frames.csv").string());
    return;
  }
  const Shown shown = read_states(frames, options);
  const ColourMap colours = chosen_colours(options, palette_of(shown.field), shown.range,
                                           white_on_surfaces, dimension_of(shown.field));
  const double text = options.text_size();
  const std::size_t count = frames.size();
  const std::size_t columns = count <= most_in_a_row ? count : (count + 1) / 2;
  const std::size_t rows = (count + columns - 1) / columns;
  const double right = 3.0 * text + colour_bar_margin(canvas, colours, true, text);
  const std::vector<View> views = options.views_or({side_view, top_view});
  const auto high = double(views.size());
  const double width = options.width(right + text + 330.0 * double(columns));
  const double title = 2.2 * text;
  double side = std::floor((width - right - text) / double(columns));
  const double height = options.height(double(rows) * (high * side + title) + text);
  side = std::min(side, std::floor(((height - text) / double(rows) - title) / high));
  canvas.start(width, height, options.unit());

  double half_width = 0;
  for (const auto& state : shown.states) {
    const Eigen::Vector3d middle = state.mesh.nodes.rowwise().mean();
    half_width = std::max(half_width,
                          1.03 * (state.mesh.nodes.colwise() - middle).colwise().norm().maxCoeff());
  }
  for (std::size_t i = 0; i < count; ++i) {
    const double x = text + double(i % columns) * (width - right - text) / double(columns);
    const std::size_t row = i / columns;
    double top = height - double(row) * (high * side + title);
    canvas.text(x + side / 2, top - 1.2 * text, time_title(frames[i], options), {.size = text});
    top -= title;
    const studies::CurvedFile& state = shown.states[i];
    const Eigen::VectorXd values = field_of(state, shown.field);
    for (const View& view : views) {
      top -= side;
      draw_surface(canvas, {x, top, side, side}, state.mesh, values, colours, view, half_width);
    }
  }
  draw_short_bar(canvas, width - right + 1.4 * text, {1.5 * text, height - 1.5 * text}, colours,
                 shown_title(shown.field, options), text);
  canvas.write(options.directory / "shapes", options.output({Format::png}));
}

}  // namespace sbeh::picture
