#include "studies/evolution/relax_input.h"

#include "studies/io/toml_reader.h"
#include "studies/parameters/evolution_input.h"
#include "studies/parameters/material_input.h"

namespace sbeh::studies {

namespace {

// ---- [start] ------------------------------------------------------------------------------------

const std::vector<StartShape>& shapes() {
  static const std::vector<StartShape> all{
      {"ellipsoid", {"reduced_volume", "axes", "kind", "order"}},
      {"harmonics", {"modes", "order", "order_modes"}},
      {"scan", {"folder", "model", "branch", "reduced_volume", "L"}},
  };
  return all;
}

Ellipsoid read_ellipsoid(const TomlTable& start) {
  const EllipsoidKeys keys =
      read_ellipsoid(start, 2, "two numbers, equatorial and polar semi-axis");
  Ellipsoid ellipsoid{keys.reduced_volume, {}, keys.prolate};
  if (!keys.axes.empty()) ellipsoid.axes = {keys.axes[0], keys.axes[1]};
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
  const std::string shape = read_shape(start, shapes());
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
  Times times = read_times(time, "profiles");
  time.reject_unknown_keys();
  input.end_time = times.end;
  input.output_times = std::move(times.output);
  input.profile_times = std::move(times.states);
  input.every_step = times.every_step;
  input.stop_at_rest = times.stop_at_rest;
}

}  // namespace

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
