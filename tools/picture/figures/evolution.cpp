#include "studies/figures/tables.h"
#include "tools/picture/figures/figures.h"
#include "tools/picture/surface/frames.h"
#include "tools/picture/surface/scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

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
  bool has_free_order;
  std::vector<std::optional<Shape>> shapes;
};

struct Evolution {
  std::vector<double> instants;  // ascending
  std::vector<Model3d> models;   // SBEH, SSH
  double half_width = 0;
  Range orders{1.0, 0.0};
};

Evolution read_evolution(const std::filesystem::path& file) {
  const auto rows = studies::read_rows(studies::figures::evolution_columns(), file);
  Evolution all;
  for (const auto& row : rows) all.instants.push_back(row.instant);
  std::ranges::sort(all.instants);
  const auto repeated = std::ranges::unique(all.instants);
  all.instants.erase(repeated.begin(), repeated.end());
  for (const model::Model model : {model::Model::SBEH, model::Model::SSH}) {
    const char* name = sbeh::name(model);
    Model3d one{name, has_free_order(model),
                std::vector<std::optional<Shape>>(all.instants.size())};
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
      all.orders.include(shape->state.fields.at("order").minCoeff());
      all.orders.include(shape->state.fields.at("order").maxCoeff());
    }
    if (any) all.models.push_back(std::move(one));
  }
  return all;
}

void draw_shape(Canvas& canvas, const std::optional<Shape>& shape, double instant,
                const Evolution& all, const ColourMap& colours, const Rect& cell, double text) {
  const double time = shape ? shape->time : instant;
  canvas.text(cell.centre_x(), cell.top() - 0.8 * text, "t = " + short_number(time),
              {.size = text, .colour = shape ? black : dark_grey});
  if (!shape) {
    canvas.text(cell.centre_x(), cell.centre_y(), "not there", {.size = text, .colour = dark_grey});
    return;
  }
  draw_surface(canvas, {cell.x, cell.y, cell.width, cell.width}, shape->state.mesh,
               shape->state.fields.at("order").row(0).transpose(), colours, from_above,
               all.half_width);
}

}  // namespace

void draw_figure_evolution(Canvas& canvas, const Options& options) {
  const Evolution all = read_evolution(options.directory / "evolution.csv");
  if (all.models.empty()) {
    fmt::print("no evolution: {} has no rows\n", (options.directory / "evolution.csv").string());
    return;
  }
  const ColourMap colours{Palette::surfaces, all.orders}, plain{Palette::plain, {0, 1}};
  const double text = options.text_size();
  const std::size_t rows = (all.instants.size() + columns - 1) / columns;  // of each model
  const double right = 3.0 * text + colour_bar_margin(canvas, colours, true, text);
  const double width = options.width(right + text + 290.0 * columns);
  const double side = std::floor((width - right - text) / columns);
  const double title = 1.6 * text, heading = 2.0 * text, row_height = side + title;
  const auto models = double(all.models.size());
  const double height = options.height(models * (heading + double(rows) * row_height) + 0.5 * text);
  canvas.start(width, height);
  double top = height;
  for (const Model3d& model : all.models) {
    canvas.text(text, top - 1.2 * text, model.name, {.size = 1.15 * text, .align = Align::left});
    top -= heading;
    for (std::size_t i = 0; i < all.instants.size(); ++i) {
      const std::size_t row = i / columns;
      const Rect cell{text + double(i % columns) * side, top - double(row + 1) * row_height, side,
                      row_height};
      draw_shape(canvas, model.shapes[i], all.instants[i], all,
                 model.has_free_order ? colours : plain, cell, text);
    }
    top -= double(rows) * row_height;
  }
  draw_short_bar(canvas, width - right + 1.4 * text, {1.5 * text, height - 1.5 * text}, colours,
                 "order β", text);
  canvas.write(options.directory / "evolution");
}

}  // namespace sbeh::picture
