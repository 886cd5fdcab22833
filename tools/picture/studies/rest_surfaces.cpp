#include "studies/rest_states/rest_row.h"
#include "tools/picture/studies/studies.h"
#include "tools/picture/surface/frames.h"
#include "tools/picture/surface/scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace sbeh::picture {
namespace {

using studies::RestRow;

constexpr std::size_t most_states = 24, most_in_a_row = 6;
constexpr double lines_of_words = 4.6;

struct ShownState {
  RestRow row;
  studies::CurvedFile state;
};

// All that have a frame, or as many as there is room for, spread over them.
std::vector<ShownState> read_shown(const std::filesystem::path& folder) {
  const studies::StatesInput input = studies::read_states(folder / "run.toml");
  std::vector<RestRow> rows =
      studies::read_rows(studies::rest_columns(input), folder / "states.csv");
  std::erase_if(rows, [](const RestRow& row) { return !row.measures; });
  const std::size_t count = std::min(rows.size(), most_states);
  std::vector<ShownState> shown;
  for (std::size_t k = 0; k < count; ++k) {
    const RestRow& row = rows[count < 2 ? 0 : k * (rows.size() - 1) / (count - 1)];
    shown.push_back({row, read_state(studies::frame_of(folder, row.key))});
  }
  return shown;
}

Range range_of(const std::vector<ShownState>& states, Field field) {
  std::vector<double> values;
  for (const ShownState& one : states) {
    const Eigen::VectorXd of_state = field_of(one.state, field);
    values.insert(values.end(), of_state.begin(), of_state.end());
  }
  return shown_range(std::move(values), field);
}

void draw_words(Canvas& canvas, const Rect& cell, const RestRow& row, const Options& options,
                double text) {
  const int falls = row.measures->negative_directions;
  const Colour red{214, 28, 28};
  double y = cell.top() - 1.2 * text;
  const auto line = [&](const std::string& words, Colour colour = {}) {
    canvas.text(cell.centre_x(), y, words, {.size = 0.85 * text, .colour = colour});
    y -= 1.1 * text;
  };
  line(fmt::format("{}: Vᵣ = {:.6g}, L = {:.4g}", row.key, row.reduced_volume, row.L));
  line(fmt::format(
      "U = {}{}, {}",
      with_minus(fmt::format("{:.9g}",
                             options.factor(studies::dimension::energy, row.L) * energy_of(row))),
      options.unit_after(studies::dimension::energy), row.measures->symmetry));
  const bool between =
      row.point == studies::RestPoint::branching || row.point == studies::RestPoint::fold;
  if (between) return line(row.point == studies::RestPoint::fold ? "a fold" : "others leave");
  line(falls == 0 ? "a minimum"
                  : fmt::format("falls in {} direction{}", falls, falls > 1 ? "s" : ""),
       falls == 0 ? Colour{} : red);
  if (row.status != studies::PointStatus::stationary) line(name(row.status), red);
}

}  // namespace

void draw_rest_surfaces(Canvas& canvas, const Options& options) {
  const std::vector<ShownState> states = read_shown(options.directory);
  if (states.empty()) {
    fmt::print("no surfaces: {} has no state\n", (options.directory / "states.csv").string());
    return;
  }
  const Field field = options.field_for(range_of(states, Field::order));
  const ColourMap colours = chosen_colours(options, palette_of(field), range_of(states, field),
                                           white_on_surfaces, dimension_of(field));
  const double text = options.text_size(), words = lines_of_words * text;
  const std::size_t rows = (states.size() + most_in_a_row - 1) / most_in_a_row;
  const std::size_t in_a_row = (states.size() + rows - 1) / rows;
  const auto columns = double(in_a_row);
  const double right = 3.0 * text + colour_bar_margin(canvas, colours, true, text);
  const std::vector<View> views = options.views_or({side_view, top_view});
  const auto high = double(views.size());
  const double width = options.width(right + text + 290.0 * columns);
  double side = std::floor((width - right - text) / columns);
  const double height = options.height(double(rows) * (high * side + words) + text);
  const double row_height = (height - text) / double(rows), column_width = side;
  side = std::min(side, std::floor((row_height - words) / high));
  canvas.start(width, height, options.unit());
  double half_width = 0;
  for (const ShownState& one : states)
    half_width = std::max(half_width, 1.03 * radius_of(one.state.mesh));
  for (std::size_t i = 0; i < states.size(); ++i) {
    const std::size_t row = i / in_a_row, column = i % in_a_row;
    const Rect cell{text + double(column) * column_width, height - double(row + 1) * row_height,
                    column_width, row_height};
    draw_words(canvas, cell, states[i].row, options, text);
    const Eigen::VectorXd values = field_of(states[i].state, field);
    double top = cell.top() - words;
    for (const View& view : views) {
      top -= side;
      draw_surface(canvas, {std::floor(cell.centre_x() - side / 2), std::floor(top), side, side},
                   states[i].state.mesh, values, colours, view, half_width);
    }
  }
  draw_short_bar(canvas, width - right + 1.4 * text, {1.5 * text, height - 1.5 * text}, colours,
                 shown_title(field, options), text);
  canvas.write(options.directory / "surfaces", options.output({Format::png}));
}

}  // namespace sbeh::picture
