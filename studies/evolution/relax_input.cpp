#include "studies/evolution/relax_input.h"

#include "studies/parameters/material_input.h"

namespace sbeh::studies {

namespace {

void read_ellipsoid(const TomlTable& start, RelaxInput& input) {
  input.start = read_ellipsoid(start, 2, "two numbers, equatorial and polar semi-axis");
  input.initial_order = start.number("order", orders, input.initial_order);
}

void read_harmonics(const TomlTable& start, RelaxInput& input) {
  Harmonics harmonics;
  const bool has_order_modes = start.has("order_modes");
  if (start.has("modes") || !has_order_modes)
    harmonics.shape = start.modes("modes", 1, largest_degree);
  if (start.has("reduced_volume")) {
    start.refuse_misspelt({"modes"});
    if (harmonics.shape.empty())
      start.fail("reduced_volume", "needs modes, whose amplitudes it multiplies by one factor");
    harmonics.reduced_volume = start.number("reduced_volume", reduced_volumes);
  }
  if (start.has("order")) harmonics.order = start.number("order", orders);
  if (has_order_modes) harmonics.order_modes = start.modes("order_modes", 1, largest_degree);
  input.start = harmonics;
}

void write_shape(TomlText& toml, const Harmonics& harmonics) {
  if (!harmonics.shape.empty()) toml.value("modes", harmonics.shape);
  if (harmonics.reduced_volume) toml.value("reduced_volume", *harmonics.reduced_volume);
  if (harmonics.order) toml.value("order", *harmonics.order);
  if (!harmonics.order_modes.empty()) toml.value("order_modes", harmonics.order_modes);
}

void read_scan(const TomlTable& start, RelaxInput& input) {
  input.start = read_scan_row(start, input.model);
}

const std::vector<StartShape<RelaxInput>>& relax_shapes() {
  static const std::vector<StartShape<RelaxInput>> all{
      {"ellipsoid",
       {"reduced_volume", "axes", "kind", "order", "order_formula", "domains", "domain_width"},
       read_ellipsoid},
      {"harmonics",
       {"modes", "reduced_volume", "order", "order_formula", "order_modes", "domains",
        "domain_width"},
       read_harmonics},
      {"scan", scan_row_keys(), read_scan, true},
  };
  return all;
}

void read_start(const TomlTable& start, RelaxInput& input) {
  const auto& shape = chosen_shape(start, relax_shapes());
  refuse_order(start, input.model,
               {"order", "order_formula", "order_modes", "domains", "domain_width"});
  shape.read(start, input);
  input.order_pattern = read_order_pattern(start, true);
  if (start.has("perturbation"))
    input.perturbation = start.modes("perturbation", 1, largest_degree);
  start.reject_unknown_keys();
}

void write_start(TomlText& toml, const RelaxInput& input) {
  toml.table("start");
  toml.value("shape", relax_shapes()[input.start.index()].name);
  std::visit([&](const auto& start) { write_shape(toml, start); }, input.start);
  if (std::holds_alternative<Ellipsoid>(input.start) && has_free_order(input.model)
      && input.order_pattern.formula.empty())
    toml.value("order", input.initial_order);
  write_order_pattern(toml, input.order_pattern);
  if (!input.perturbation.empty()) toml.value("perturbation", input.perturbation);
}

}  // namespace

RelaxInput read_relax(const std::filesystem::path& path) { return relax_in(TomlFile::parse(path)); }

RelaxInput relax_in(const TomlTable& file) {
  file.has("model");  // a known key, wherever it may be left out
  const TomlTable start = file.table("start");
  const TomlTable time = file.table("time");
  const TomlTable material = file.table("material");
  const TomlTable numerics = file.table("numerics");
  file.has("units");
  file.reject_unknown_keys();
  const auto model = named_model(file, start, relax_shapes());
  RelaxInput input;
  input.units = read_units(file);
  input.model = model.value_or(input.model);
  material.measured_by(lengths_of(input.units));
  read_start(start, input);
  static_cast<Physics&>(input) =
      read_physics(file, model, material, [&] { return origin_of_any(input.start); });
  if (input.material.conserves_order() && has_free_order(input.model) && !start.has("order")
      && !start.has("order_formula")) {
    input.initial_order = outside_of(start, input.material, input.order_pattern);
    if (auto* harmonics = std::get_if<Harmonics>(&input.start))
      harmonics->order = input.initial_order;
  }
  input.numerics = read_numerics<axisym::Numerics>(numerics);
  time.measured_by(read_scales(file, input.units, input.material, input.model));
  input.times = read_times(time, "profiles");
  time.reject_unknown_keys();
  return input;
}

std::string describe(const RelaxInput& input, std::string_view version) {
  TomlText toml(version);
  toml.value("model", input.model);
  write_start(toml, input);
  write_material(toml, input.material, input.model);
  write_numerics(toml, input.numerics);
  write_times(toml, input.times, "profiles");
  write_units(toml, input.units);
  return toml.text();
}

}  // namespace sbeh::studies
