#include "studies/run_input.h"

#include "studies/material_input.h"
#include "studies/scan_input.h"
#include "studies/spelling.h"
#include "studies/toml_reader.h"

#include <fmt/format.h>

#include <algorithm>

namespace sbeh::studies {

namespace {

constexpr Interval reduced_volumes{.low = 0, .high = 1, .low_open = true};
constexpr int largest_degree = 32;
constexpr int fewest_triangles = 20, most_triangles = 200'000;

struct Shape {
  std::string name;
  std::vector<std::string> keys;
};
const std::vector<Shape>& shapes() {
  static const std::vector<Shape> all{
      {"ellipsoid", {"reduced_volume", "axes", "kind", "triangles", "order"}},
      {"harmonics", {"modes", "triangles", "order"}},
      {"mesh", {"file", "order"}},
      {"scan", {"folder", "model", "branch", "reduced_volume", "L", "triangles"}},
      {"frame", {"file"}},
  };
  return all;
}

// Throws for keys which belong to other shapes than the one named `chosen`.
void refuse_keys_of_other_shapes(const TomlTable& surface, const std::string& chosen) {
  const auto has_key = [](const Shape& shape, const std::string& key) {
    return std::find(shape.keys.begin(), shape.keys.end(), key) != shape.keys.end();
  };
  const Shape& own = *std::find_if(shapes().begin(), shapes().end(),
                                   [&](const Shape& shape) { return shape.name == chosen; });
  for (const Shape& other : shapes())
    for (const std::string& key : other.keys)
      if (!has_key(own, key)) surface.refuse(key, "has no place with shape = " + in_quotes(chosen));
}

Ellipsoid3d read_ellipsoid(const TomlTable& surface) {
  Ellipsoid3d ellipsoid;
  if (surface.has("axes")) {
    surface.refuse("reduced_volume", "must not be given together with axes");
    surface.refuse("kind", "must not be given together with axes, which tell it");
    const std::vector<double> axes = surface.numbers("axes", above(0));
    if (axes.size() != 3)
      surface.fail("axes", "must be three numbers, the semi-axes along x, y, z");
    ellipsoid.axes = Eigen::Vector3d(axes[0], axes[1], axes[2]);
  } else {
    ellipsoid.reduced_volume = surface.number("reduced_volume", reduced_volumes);
  }
  ellipsoid.prolate = surface.word("kind", {"oblate", "prolate"}, "oblate") == "prolate";
  return ellipsoid;
}

void read_surface(const TomlTable& surface, RunInput& input) {
  std::vector<std::string> names;
  for (const Shape& shape : shapes()) names.push_back(shape.name);
  const std::string shape = surface.word("shape", names);
  refuse_keys_of_other_shapes(surface, shape);
  refuse_order(surface, input.model, {"order"});
  if (shape == "ellipsoid") input.start = read_ellipsoid(surface);
  if (shape == "harmonics")
    input.start = HarmonicSphere{surface.harmonics("modes", largest_degree)};
  if (shape == "mesh") input.start = MeshFileStart{surface.text("file")};
  if (shape == "scan") input.start = read_scan_row(surface, input.model);
  if (shape == "frame") input.start = FrameStart{surface.text("file")};
  input.triangles = surface.integer("triangles", fewest_triangles, most_triangles, input.triangles);
  input.initial_order = surface.number("order", between(0, 1), input.initial_order);
  if (surface.has("perturbation"))
    input.perturbation = surface.harmonics("perturbation", largest_degree);
  surface.reject_unknown_keys();
}

void read_time(const TomlTable& time, RunInput& input) {
  input.end_time = time.number("end", above(0));
  const Interval run = between(0, input.end_time);
  input.output_times = time.grid("output", run, default_output_times(input.end_time));
  input.frame_times = time.grid("frames", run, default_profile_times(input.end_time));
  input.stop_at_rest = time.boolean("stop_at_rest", input.stop_at_rest);
  time.reject_unknown_keys();
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
