#include "studies/evolution/run_input.h"

#include "studies/io/toml_reader.h"
#include "studies/parameters/evolution_input.h"
#include "studies/parameters/material_input.h"

namespace sbeh::studies {

namespace {

constexpr int fewest_triangles = 20, most_triangles = 200'000;

const std::vector<StartShape>& shapes() {
  static const std::vector<StartShape> all{
      {"ellipsoid", {"reduced_volume", "axes", "kind", "triangles", "order"}},
      {"harmonics", {"modes", "triangles", "order"}},
      {"mesh", {"file", "order"}},
      {"scan", {"folder", "model", "branch", "reduced_volume", "L", "triangles"}},
      {"frame", {"file"}},
  };
  return all;
}

Ellipsoid3d read_ellipsoid(const TomlTable& surface) {
  const EllipsoidKeys keys =
      read_ellipsoid(surface, 3, "three numbers, the semi-axes along x, y, z");
  Ellipsoid3d ellipsoid{keys.reduced_volume, {}, keys.prolate};
  if (!keys.axes.empty()) ellipsoid.axes = Eigen::Vector3d(keys.axes.data());
  return ellipsoid;
}

void read_surface(const TomlTable& surface, RunInput& input) {
  const std::string shape = read_shape(surface, shapes());
  refuse_order(surface, input.model, {"order"});
  if (shape == "ellipsoid") input.start = read_ellipsoid(surface);
  if (shape == "harmonics")
    input.start = HarmonicSphere{surface.harmonics("modes", largest_degree)};
  if (shape == "mesh") input.start = MeshFileStart{surface.text("file")};
  if (shape == "scan") input.start = read_scan_row(surface, input.model);
  if (shape == "frame") input.start = FrameStart{surface.text("file")};
  input.triangles = surface.integer("triangles", fewest_triangles, most_triangles, input.triangles);
  input.initial_order = surface.number("order", orders, input.initial_order);
  if (surface.has("perturbation"))
    input.perturbation = surface.harmonics("perturbation", largest_degree);
  surface.reject_unknown_keys();
}

void read_time(const TomlTable& time, RunInput& input) {
  Times times = read_times(time, "frames");
  input.checkpoint_minutes = time.number("checkpoint_minutes", above(0), input.checkpoint_minutes);
  time.reject_unknown_keys();
  input.end_time = times.end;
  input.output_times = std::move(times.output);
  input.frame_times = std::move(times.states);
  input.every_step = times.every_step;
  input.stop_at_rest = times.stop_at_rest;
}

}  // namespace

RunInput read_run(const std::filesystem::path& path) {
  const TomlTable file = TomlFile::parse(path);
  const std::string model = file.word("model", model_words());
  const TomlTable surface = file.table("surface"), time = file.table("time"),
                  material = file.table("material"), numerics = file.table("numerics");
  file.reject_unknown_keys();
  RunInput input;
  input.model = model_of(model);
  read_surface(surface, input);
  if (const auto* row = std::get_if<ScanRow>(&input.start))
    input.material = input.material.with_L(row->L);
  input.material = read_material(material, input.model, input.material);
  input.numerics = read_numerics_3d(numerics);
  read_time(time, input);
  return input;
}

}  // namespace sbeh::studies
