#include "studies/parameters/material_number.h"
#include "studies/rest_states/rest_row.h"
#include "tools/picture/chart/legend.h"
#include "tools/picture/chart/panels.h"
#include "tools/picture/studies/studies.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <functional>
#include <map>
#include <utility>

namespace sbeh::picture {
namespace {

using studies::RestPoint;
using studies::RestRow;

using Paths = std::map<int, std::vector<RestRow>>;

// Of the rows that have a state; what leaves begins at the state where it leaves.
Paths read_paths(const std::filesystem::path& folder, const studies::StatesInput& input) {
  Paths paths;
  std::map<int, RestRow> by_number;
  for (RestRow& row : studies::read_rows(studies::rest_columns(input), folder / "states.csv")) {
    if (!row.measures || !row.path) continue;
    std::vector<RestRow>& path = paths[*row.path];
    if (path.empty() && row.from && by_number.contains(*row.from)) {
      path.push_back(by_number.at(*row.from));
      path.back().measures->negative_directions = row.measures->negative_directions;
      path.back().point = RestPoint::step;  // its mark is that of the other path
    }
    by_number.emplace(row.key, row);
    path.push_back(std::move(row));
  }
  return paths;
}

struct Quantity {
  std::string title;
  std::function<double(const RestRow&)> of;
};

Range range_of(const Paths& paths, const std::function<double(const RestRow&)>& of) {
  Range range{of(paths.begin()->second.front()), of(paths.begin()->second.front())};
  for (const auto& [number, path] : paths)
    for (const RestRow& row : path) range.include(of(row));
  return range;
}

Axis axis_of(const Range& range, double length, double spacing, const std::string& title) {
  const double room = std::max(0.05 * range.width(), 1e-6);
  return exact_axis(range.low - room, range.high + room, length, spacing, title);
}

bool is_minimum(const RestRow& row) { return row.measures->negative_directions == 0; }

// From a row to the next one, by that which is no branching or fold: these are of neither side.
bool piece_is_minimum(const std::vector<RestRow>& path, std::size_t row) {
  return is_minimum(path[path[row + 1].point == RestPoint::step ? row + 1 : row]);
}

struct Look {
  RestPoint point;
  Marker marker;
  const char* meaning;
};
constexpr std::array<Look, 3> looks{
    Look{RestPoint::branching, Marker::full, "others leave"},
    Look{RestPoint::fold, Marker::diamond, "fold"},
    Look{RestPoint::joins, Marker::hollow, "joins states with an axis"}};

void draw_paths(Chart& chart, const Paths& paths, const std::vector<Colour>& colours,
                const Quantity& x, const Quantity& y, double text) {
  std::size_t k = 0;
  for (const auto& [number, path] : paths) {
    const Colour colour = colours[k++];
    Points line{{x.of(path.front()), y.of(path.front())}};
    for (std::size_t i = 0; i + 1 < path.size(); ++i) {
      line.push_back({x.of(path[i + 1]), y.of(path[i + 1])});
      if (i + 2 < path.size() && piece_is_minimum(path, i + 1) == piece_is_minimum(path, i))
        continue;
      chart.curve(line, {.colour = colour,
                         .width = 2.2,
                         .pattern = piece_is_minimum(path, i) ? Pattern::solid : Pattern::dashed});
      line = {line.back()};
    }
    for (const Look& look : looks)
      for (const RestRow& row : path)
        if (row.point == look.point)
          chart.markers({{x.of(row), y.of(row)}}, look.marker, colour, 0.7 * text);
  }
}

// Of its own states, in their order, each once.
std::string classes_of(int number, const std::vector<RestRow>& path) {
  std::vector<std::string> classes;
  for (const RestRow& row : path)
    if (row.path == number && std::ranges::find(classes, row.measures->symmetry) == classes.end())
      classes.push_back(row.measures->symmetry);
  return fmt::format("{}", fmt::join(classes, ", "));
}

std::vector<LegendEntry> legend_of(const Paths& paths, const std::vector<Colour>& colours) {
  std::vector<LegendEntry> entries;
  std::size_t k = 0;
  for (const auto& [number, path] : paths)
    entries.push_back(line_entry({.colour = colours[k++], .width = 2.2},
                                 fmt::format("path {}: {}", number, classes_of(number, path))));
  const auto any = [&](const auto& is) {
    return std::ranges::any_of(
        paths, [&](const auto& path) { return std::ranges::any_of(path.second, is); });
  };
  if (any(is_minimum)) entries.push_back(line_entry({.width = 2.2}, "minima"));
  if (any(std::not_fn(is_minimum)))
    entries.push_back(line_entry({.width = 2.2, .pattern = Pattern::dashed}, "saddles"));
  for (const Look& look : looks)
    if (any([&](const RestRow& row) { return row.point == look.point; }))
      entries.push_back(marker_entry(look.marker, dark_grey, look.meaning));
  return entries;
}

Quantity parameter_of(const Options& options, const std::string& parameter) {
  using namespace studies::dimension;
  const studies::MaterialNumber* number = studies::MaterialNumber::named(parameter);
  if (!number) return {"reduced volume Vᵣ", [](const RestRow& row) { return row.reduced_volume; }};
  if (parameter == "L") return {number->title(), [](const RestRow& row) { return row.L; }};
  const auto dimension = studies::dimension_of(parameter).value_or(none);
  return {options.titled(number->title(), dimension), [&options, dimension](const RestRow& row) {
            return (dimension == none ? 1 : options.factor(dimension, row.L)) * row.followed;
          }};
}

}  // namespace

void draw_rest_branches(Canvas& canvas, const Options& options) {
  const studies::StatesInput input = studies::read_states(options.directory / "run.toml");
  if (!input.follow) {
    fmt::print("no branches: {} has no [follow]\n", (options.directory / "run.toml").string());
    return;
  }
  const Paths paths = read_paths(options.directory, input);
  if (paths.empty())
    throw InputError((options.directory / "states.csv").string() + ": has no state");
  const Quantity x = parameter_of(options, input.follow->parameter);
  const std::array<Quantity, 2> quantities{
      Quantity{options.titled("energy U", studies::dimension::energy),
               [&](const RestRow& row) {
                 return options.factor(studies::dimension::energy, row.L) * energy_of(row);
               }},
      Quantity{options.titled("longest − middle length", studies::dimension::length),
               [&](const RestRow& row) {
                 const auto& lengths = row.measures->lengths;
                 return options.factor(studies::dimension::length) * (lengths[2] - lengths[1]);
               }}};
  const std::vector<Colour> colours = line_colours(paths.size());
  const double text = options.text_size(), least = 820.0;
  const auto legend = legend_of(paths, colours);
  const double room = options.width(2 * 600.0) - 2.0 * text,
               legend_at = legend_height(canvas, legend, room, text);
  const PanelGrid grid = arranged({.count = quantities.size(),
                                   .most_columns = 2,
                                   .usual_width = 600.0,
                                   .least_picture = least,
                                   .least_width = canvas.text_width(x.title, text),
                                   .left = 5.8 * text,
                                   .right = 1.2 * text,
                                   .below = below_axis(text),
                                   .above = 1.2 * text,
                                   .bottom = 1.6 * text + legend_at,
                                   .top = 0.6 * text},
                                  options);
  canvas.start(grid.width, grid.height, options.unit());
  for (std::size_t k = 0; k < quantities.size(); ++k) {
    const Rect inside = grid.inside(k);
    const Quantity& y = quantities[k];
    Chart chart(canvas, inside, text,
                axis_of(range_of(paths, x.of), inside.width, 4.0 * text, x.title),
                axis_of(range_of(paths, y.of), inside.height, 3.0 * text, y.title));
    draw_paths(chart, paths, colours, x, y, text);
  }
  draw_legend(canvas, legend, {0.5 * (grid.width - room), 0.6 * text, room, legend_at}, text);
  canvas.write(options.directory / "branches", options.output());
}

}  // namespace sbeh::picture
