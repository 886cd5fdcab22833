#include "studies/figures/tables.h"
#include "tools/picture/figures/figures.h"
#include "tools/picture/surface/frames.h"
#include "tools/picture/surface/scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace sbeh::picture {
namespace {

const View from_above{{-0.25, -0.75, 0.75}, {0, 0, 1}};
constexpr std::size_t columns = 5;

struct Shape {
  double time;
  studies::CurvedFile state;
};

// One model: a shape per instant, or none.
struct Model3d {
  std::string name;  // with k₀ where there is one
  std::vector<std::optional<Shape>> shapes;
  Field field = Field::order;
  Range range{};
};

struct Evolution {
  std::vector<double> instants;  // ascending
  std::vector<Model3d> models;   // SBEH, SSH
  double half_width = 0;
};

Range range_of(const Model3d& model, Field field) {
  std::vector<double> values;
  for (const auto& shape : model.shapes)
    if (shape) {
      const Eigen::VectorXd of_shape = field_of(shape->state, field);
      values.insert(values.end(), of_shape.begin(), of_shape.end());
    }
  return values.empty() ? Range() : shown_range(std::move(values), field);
}

Evolution read_evolution(const std::filesystem::path& file, const Options& options) {
  const auto rows = studies::read_rows(studies::figures::evolution_columns(), file);
  Evolution all;
  for (const auto& row : rows) all.instants.push_back(row.instant);
  std::ranges::sort(all.instants);
  all.instants.erase(std::unique(all.instants.begin(), all.instants.end()), all.instants.end());
  for (const model::Model model : {model::Model::SBEH, model::Model::SSH}) {
    const char* name = sbeh::name(model);
    Model3d one{name, std::vector<std::optional<Shape>>(all.instants.size())};
    bool any = false;
    for (const auto& row : rows) {
      if (row.model != model) continue;
      any = true;
      if (row.residual_stiffness > 0)
        one.name = fmt::format("{} with k₀ = {:.4g}", name, row.residual_stiffness);
      if (!row.nearest) continue;
      auto& shape = one.shapes[std::size_t(std::ranges::find(all.instants, row.instant)
                                           - all.instants.begin())];
      shape = Shape{row.nearest->time, read_state(file.parent_path() / row.nearest->frame)};
      all.half_width = std::max(all.half_width, 1.02 * radius_of(shape->state.mesh));
    }
    one.field = options.field_for(range_of(one, Field::order));
    one.range = range_of(one, one.field);
    if (any) all.models.push_back(std::move(one));
  }
  return all;
}

void draw_shape(Canvas& canvas, const std::optional<Shape>& shape, double instant, Field field,
                const ColourMap& colours, const View& view, double half_width, const Rect& cell,
                double text) {
  const double time = shape ? shape->time : instant;
  canvas.text(cell.centre_x(), cell.top() - 1.3 * text, "t = " + short_number(time),
              {.size = text, .colour = shape ? black : dark_grey});
  if (!shape) {
    canvas.text(cell.centre_x(), cell.centre_y(), "not there", {.size = text, .colour = dark_grey});
    return;
  }
  draw_surface(canvas, {cell.x, cell.y, cell.width, cell.width}, shape->state.mesh,
               field_of(shape->state, field), colours, view, half_width);
}

}  // namespace

void draw_figure_evolution(Canvas& canvas, const Options& options) {
  const Evolution all = read_evolution(options.directory / "evolution.csv", options);
  if (all.models.empty()) {
    fmt::print("no evolution: {} has no rows\n", (options.directory / "evolution.csv").string());
    return;
  }
  const double text = options.text_size();
  std::vector<ColourMap> colours;  // of the models
  double bar = 0.0;
  for (const Model3d& model : all.models) {
    colours.push_back(
        chosen_colours(options, palette_of(model.field), model.range, white_on_surfaces));
    bar = std::max(bar, colour_bar_margin(canvas, colours.back(), true, text));
  }
  const std::size_t rows = (all.instants.size() + columns - 1) / columns;  // of each model
  const double right = 3.0 * text + bar;
  const double width = options.width(right + text + 290.0 * columns);
  const double side = std::floor((width - right - text) / columns);
  const double title = 2.2 * text, heading = 2.0 * text, row_height = side + title;
  const auto models = double(all.models.size());
  const double height = options.height(models * (heading + double(rows) * row_height) + 0.5 * text);
  canvas.start(width, height, options.unit());
  double top = height;
  for (std::size_t m = 0; m < all.models.size(); ++m) {
    const Model3d& model = all.models[m];
    canvas.text(text, top - 1.2 * text, model.name, {.size = 1.15 * text, .align = Align::left});
    top -= heading;
    for (std::size_t i = 0; i < all.instants.size(); ++i) {
      const std::size_t row = i / columns;
      const Rect cell{text + double(i % columns) * side, top - double(row + 1) * row_height, side,
                      row_height};
      draw_shape(canvas, model.shapes[i], all.instants[i], model.field, colours[m],
                 options.views_or({from_above}).front(), all.half_width, cell, text);
    }
    const double bottom = top - double(rows) * row_height;
    draw_short_bar(canvas, width - right + 1.4 * text, {bottom + text, top - text}, colours[m],
                   shown_title(model.field, options), text);
    top = bottom;
  }
  canvas.write(options.directory / "evolution", options.output());
}

}  // namespace sbeh::picture
