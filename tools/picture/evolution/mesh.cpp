#include "meshing/curvature.h"
#include "meshing/measures.h"
#include "studies/mesh_files/mesh_file.h"
#include "tools/picture/evolution/evolution.h"
#include "tools/picture/surface/frames.h"
#include "tools/picture/surface/scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace sbeh::picture {
namespace {

studies::CurvedFile read(const std::filesystem::path& file) {
  if (auto curved = studies::read_curved_mesh(file)) return std::move(*curved);
  throw InputError(fmt::format("{}: has plain triangles; sbeh mesh file makes curved ones of them",
                               file.string()));
}

// What the surface is coloured by.
struct Quantity3d {
  Eigen::VectorXd values;
  Field field;
};

Quantity3d quantity_of(const studies::CurvedFile& file, const Options& options) {
  const auto order = file.fields.find("order");
  if (order != file.fields.end() && order->second.rows() == 1) {
    Eigen::VectorXd values = order->second.row(0).transpose();
    if (options.field_for({values.minCoeff(), values.maxCoeff()}) == Field::order)
      return {std::move(values), Field::order};
  } else if (options.field == Field::order) {
    throw InputError("--field order: the mesh has no order");
  }
  return {meshing::node_mean_curvature(file.mesh), Field::curvature};
}

}  // namespace

void draw_mesh(Canvas& canvas, const Options& options) {
  const std::filesystem::path& path = options.directory;
  const studies::CurvedFile file = read(path);
  const meshing::CurvedMesh& mesh = file.mesh;
  const Quantity3d quantity = quantity_of(file, options);
  const Range range = shown_range({quantity.values.begin(), quantity.values.end()}, quantity.field);
  const ColourMap colours =
      chosen_colours(options, palette_of(quantity.field), range, white_on_surfaces);

  const double text = options.text_size();
  const double width = options.width(1600.0), height = options.height(880.0);
  canvas.start(width, height, options.unit());
  const double bar = 2.5 * text + colour_bar_margin(canvas, colours, true, text);
  const double top = 3.2 * text, bottom = 2.0 * text;
  const std::vector<View> views = options.views_or({side_view, top_view});
  const auto count = double(views.size());
  const double side = std::floor(std::min((width - bar - text) / count, height - top - bottom));
  const double left = std::max(0.0, (width - bar - count * side) / 2);

  double x = left;
  for (const View& view : views) {
    const std::string title = view.from == side_view.from ? "from the side"
                            : view.from == top_view.from
                                ? "along the z axis"
                                : fmt::format("from ({:.3g}, {:.3g}, {:.3g})", view.from[0],
                                              view.from[1], view.from[2]);
    draw_surface(canvas, {x, bottom, side, side}, mesh, quantity.values, colours, view,
                 1.06 * radius_of(mesh), Edges::shown);
    canvas.text(x + 0.5 * side, 1.1 * text, title, {.size = 0.85 * text, .colour = dark_grey});
    x += side;
  }
  const double area = meshing::area(mesh), volume = meshing::volume(mesh);
  canvas.text(
      0.5 * width, height - 1.5 * text,
      fmt::format("{}: {} triangles of order {}, A = {:.5g}, Vᵣ = {:.4f}", path.filename().string(),
                  mesh.triangle_count(), mesh.order, area, meshing::reduced_volume(area, volume)),
      {.size = 1.15 * text});
  draw_short_bar(canvas, left + count * side + 0.4 * text, {bottom, bottom + side}, colours,
                 shown_title(quantity.field, options), text);
  canvas.write(std::filesystem::path(path).replace_extension(), options.output({Format::png}));
}

}  // namespace sbeh::picture
