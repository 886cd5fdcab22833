#include "studies/relax_input.h"

#include "studies/material_input.h"
#include "studies/scan_input.h"
#include "studies/spelling.h"
#include "studies/toml_reader.h"

#include <fmt/format.h>

#include <algorithm>

namespace sbeh::studies {

namespace {

constexpr Interval reduced_volumes{.low = 0, .high = 1, .low_open = true};
constexpr Interval orders = between(0, 1);
constexpr int largest_degree = 32;       // of harmonics
constexpr double largest_aspect = 1000;  // of ellipsoids

// ---- [start] ------------------------------------------------------------------------------------

struct Shape {
  std::string name;
  std::vector<std::string> keys;
};

const std::vector<Shape>& shapes() {
  static const std::vector<Shape> all{
      {"ellipsoid", {"reduced_volume", "axes", "kind", "order"}},
      {"harmonics", {"modes", "order", "order_modes"}},
      {"scan", {"folder", "model", "branch", "reduced_volume", "L"}},
  };
  return all;
}

std::vector<std::string> shape_names() {
  std::vector<std::string> names;
  for (const Shape& shape : shapes()) names.push_back(shape.name);
  return names;
}

/// Throws for keys which belong to other shapes than the one named `chosen`.
void refuse_keys_of_other_shapes(const TomlTable& start, const std::string& chosen) {
  const auto has_key = [](const Shape& shape, const std::string& key) {
    return std::find(shape.keys.begin(), shape.keys.end(), key) != shape.keys.end();
  };
  const Shape& own = *std::find_if(shapes().begin(), shapes().end(),
                                   [&](const Shape& shape) { return shape.name == chosen; });
  for (const Shape& other : shapes())
    for (const std::string& key : other.keys) {
      if (has_key(own, key)) continue;
      std::string owners;
      for (const Shape& shape : shapes())
        if (has_key(shape, key)) owners += (owners.empty() ? "" : " and ") + in_quotes(shape.name);
      start.refuse(key, "belongs to shape = " + owners + ", not to " + in_quotes(chosen));
    }
}

Ellipsoid read_ellipsoid(const TomlTable& start) {
  Ellipsoid ellipsoid;
  if (start.has("axes")) {
    start.refuse("reduced_volume", "must not be given together with axes");
    start.refuse("kind", "must not be given together with axes, which tell it");
    const std::vector<double> axes = start.numbers("axes", above(0));
    if (axes.size() != 2) start.fail("axes", "must be two numbers, equatorial and polar semi-axis");
    if (std::max(axes[0], axes[1]) / largest_aspect > std::min(axes[0], axes[1]))
      start.fail("axes",
                 fmt::format("must not differ by more than a factor of {}", largest_aspect));
    ellipsoid.axes = {axes[0], axes[1]};
  } else {
    ellipsoid.reduced_volume = start.number("reduced_volume", reduced_volumes);
  }
  ellipsoid.prolate = start.word("kind", {"oblate", "prolate"}, "oblate") == "prolate";
  return ellipsoid;
}

Harmonics read_harmonics(const TomlTable& start) {
  Harmonics harmonics;
  const bool has_order_modes = start.has("order_modes");
  if (start.has("modes") || !has_order_modes)
    harmonics.shape = start.modes("modes", 1, largest_degree);
  if (start.has("order")) harmonics.order = start.number("order", orders);
  if (has_order_modes) harmonics.order_modes = start.modes("order_modes", 1, largest_degree);
  return harmonics;
}

void read_start(const TomlTable& start, RelaxInput& input) {
  const std::string shape = start.word("shape", shape_names());
  refuse_keys_of_other_shapes(start, shape);
  refuse_order(start, input.model, {"order", "order_modes"});
  if (shape == "ellipsoid") {
    input.start = read_ellipsoid(start);
    input.initial_order = start.number("order", orders, input.initial_order);
  } else if (shape == "harmonics") {
    input.start = read_harmonics(start);
  } else {
    input.start = read_scan_row(start, input.model);
  }
  start.reject_unknown_keys();
}

// ---- [time] -------------------------------------------------------------------------------------

void read_time(const TomlTable& time, RelaxInput& input) {
  input.end_time = time.number("end", above(0));
  const Interval run = between(0, input.end_time);
  input.output_times = time.grid("output", run, default_output_times(input.end_time));
  input.profile_times = time.grid("profiles", run, default_profile_times(input.end_time));
  input.stop_at_rest = time.boolean("stop_at_rest", input.stop_at_rest);
  time.reject_unknown_keys();
}

std::vector<double> default_times(double first, double end, int count) {
  std::vector<double> times =
      evenly_spaced(std::min(first, end / 100), end, count, Spacing::logarithmic);
  times.insert(times.begin(), 0);
  return times;
}

}  // namespace

std::vector<double> default_output_times(double end) { return default_times(1e-5, end, 200); }

std::vector<double> default_profile_times(double end) { return default_times(1e-3, end, 7); }

RelaxInput read_relax(const std::filesystem::path& path) {
  const TomlTable file = TomlFile::parse(path);
  const std::string model = file.word("model", model_words());
  const TomlTable start = file.table("start");
  const TomlTable time = file.table("time");
  const TomlTable material = file.table("material");
  const TomlTable numerics = file.table("numerics");
  file.reject_unknown_keys();
  RelaxInput input;
  input.model = model_of(model);
  read_start(start, input);
  if (const auto* row = std::get_if<ScanRow>(&input.start))
    input.material = input.material.with_L(row->L);
  input.material = read_material(material, input.model, input.material);
  input.numerics = read_numerics(numerics);
  read_time(time, input);
  return input;
}

}  // namespace sbeh::studies
