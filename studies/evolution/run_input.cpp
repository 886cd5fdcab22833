#include "studies/evolution/run_input.h"

#include "meshing/resolution.h"
#include "studies/evolution/frame_file.h"
#include "studies/io/input_path.h"
#include "studies/modes/mode_file.h"
#include "studies/parameters/material_input.h"

#include <fmt/format.h>

#include <functional>

namespace sbeh::studies {

namespace fs = std::filesystem;

namespace {

void read_ellipsoid(const TomlTable& surface, RunInput& input) {
  input.start = read_ellipsoid(surface, 3, "three numbers, the semi-axes along x, y, z");
}

void read_harmonics(const TomlTable& surface, RunInput& input) {
  HarmonicSphere sphere{surface.harmonics("modes", largest_degree), {}};
  if (surface.has("reduced_volume"))
    sphere.reduced_volume = surface.number("reduced_volume", reduced_volumes);
  input.start = sphere;
}
void write_shape(TomlText& toml, const HarmonicSphere& sphere) {
  toml.value("modes", sphere.modes);
  if (sphere.reduced_volume) toml.value("reduced_volume", *sphere.reduced_volume);
}

void read_mesh_file(const TomlTable& surface, RunInput& input) {
  input.start = MeshFileStart{surface.path("file")};
}
void write_shape(TomlText& toml, const MeshFileStart& mesh) { toml.value("file", mesh.file); }

void read_scan(const TomlTable& surface, RunInput& input) {
  input.start = read_scan_row(surface, input.model);
}

void read_frame_file(const TomlTable& surface, RunInput& input) {
  input.start = FrameStart{surface.path("file")};
}
void write_shape(TomlText& toml, const FrameStart& frame) { toml.value("file", frame.file); }

void read_mode_file(const TomlTable& surface, RunInput& input) {
  input.start = ModeStart{surface.path("file"), surface.number("amplitude")};
}
void write_shape(TomlText& toml, const ModeStart& mode) {
  toml.value("file", mode.file);
  toml.value("amplitude", mode.amplitude);
}

std::vector<std::string> and_triangles(std::vector<std::string> keys) {
  keys.emplace_back("triangles");
  return keys;
}

const ParameterNames order_keys{"order",        "order_formula", "domains",
                                "domain_width", "order_modes",   "order_noise"};
std::vector<std::string> and_order(std::vector<std::string> keys) {
  keys.insert(keys.end(), order_keys.begin(), order_keys.end());
  return keys;
}

const std::vector<StartShape<RunInput>>& run_shapes() {
  static const std::vector<StartShape<RunInput>> all{
      {"ellipsoid", and_order({"reduced_volume", "axes", "kind", "triangles"}), read_ellipsoid},
      {"harmonics", and_order({"modes", "reduced_volume", "triangles"}), read_harmonics},
      {"mesh", and_order({"file"}), read_mesh_file},
      {"scan", and_triangles(scan_row_keys()), read_scan, true},
      {"frame", {"file"}, read_frame_file, true},
      {"mode", {"file", "amplitude", "triangles"}, read_mode_file, true},
  };
  return all;
}

void read_surface(const TomlTable& surface, RunInput& input) {
  const auto& shape = chosen_shape(surface, run_shapes());
  refuse_order(surface, input.model, order_keys);
  shape.read(surface, input);
  input.triangles = surface.integer("triangles", meshing::fewest_triangles, meshing::most_triangles,
                                    input.triangles);
  input.initial_order = surface.number("order", orders, input.initial_order);
  input.order_pattern = read_order_pattern(surface, false);
  if (surface.has("perturbation"))
    input.perturbation = surface.harmonics("perturbation", largest_degree);
  input.symmetry.mesh = input.symmetry.kept = read_symmetry(surface, "symmetry");
  if (surface.has("keep_symmetry")) {
    surface.refuse_misspelt({"symmetry"});
    input.symmetry.kept = read_symmetry(surface, "keep_symmetry");
    if (!input.symmetry.mesh.contains(input.symmetry.kept))
      surface.fail("keep_symmetry",
                   fmt::format("must be part of symmetry = \"{}\", that of the triangles",
                               input.symmetry.mesh.symbol()));
  }
  surface.reject_unknown_keys();
}

// Newton's method knows the models of a scan, and their L, which is L1.
void require_rest_states(const TomlTable& time, const RunInput& input) {
  if (input.finish == RunFinish::flow) return;
  if (input.model != rest_model(input.model))
    time.fail("finish", fmt::format("belongs to SBEH and SSH, not to {}", name(input.model)));
  if (!(input.material.L1 > 0)) time.fail("finish", "needs L1 > 0");
  if (!input.times.stop_at_rest)
    time.fail("finish", "belongs to runs that end at rest: stop_at_rest = true");
}

void read_time(const TomlTable& time, RunInput& input) {
  input.times = read_times(time, "frames");
  read_value(time, "finish", input.finish);
  require_rest_states(time, input);
  input.checkpoint_minutes = time.number("checkpoint_minutes", above(0), input.checkpoint_minutes);
  time.reject_unknown_keys();
}

void write_surface(TomlText& toml, const RunInput& input) {
  const auto& shape = run_shapes()[input.start.index()];
  toml.table("surface");
  toml.value("shape", shape.name);
  std::visit([&](const auto& start) { write_shape(toml, start); }, input.start);
  if (shape.has("triangles")) toml.value("triangles", input.triangles);
  if (shape.has("order") && has_free_order(input.model)) {
    if (input.order_pattern.formula.empty()) toml.value("order", input.initial_order);
    write_order_pattern(toml, input.order_pattern);
  }
  if (!input.perturbation.empty()) toml.value("perturbation", input.perturbation);
  if (input.symmetry.mesh.is_trivial()) return;
  toml.value("symmetry", input.symmetry.mesh.symbol());
  toml.value("keep_symmetry", input.symmetry.kept.symbol());
}

bool is_gone(const RunInput& input) {
  return std::visit(
      [](const auto& start) {
        if constexpr (requires { is_there(start); })
          return !is_there(start);
        else
          return false;
      },
      input.start);
}

using FindOrigin = std::function<std::optional<Origin>(const RunInput&)>;

RunInput read_with(const TomlTable& file, const FindOrigin& find_origin) {
  file.has("model");  // a known key, wherever it may be left out
  const TomlTable surface = file.table("surface"), time = file.table("time"),
                  material = file.table("material"), numerics = file.table("numerics");
  file.has("units");
  file.reject_unknown_keys();
  const auto model = named_model(file, surface, run_shapes());
  RunInput input;
  input.units = read_units(file);
  input.model = model.value_or(input.model);
  for (const TomlTable& table : {surface, material}) table.measured_by(lengths_of(input.units));
  read_surface(surface, input);
  static_cast<Physics&>(input) =
      read_physics(file, model, material, [&] { return find_origin(input); });
  if (input.material.conserves_order() && has_free_order(input.model) && !surface.has("order")
      && !surface.has("order_formula"))
    input.initial_order = outside_of(surface, input.material, input.order_pattern);
  input.numerics = read_numerics<surface3d::Numerics>(numerics);
  if (input.numerics.integrator == surface3d::Integrator::variational
      && area_constraint(input.model) == model::AreaConstraint::global)
    numerics.fail("integrator", surface3d::no_variational_steps);
  time.measured_by(read_scales(file, input.units, input.material, input.model));
  read_time(time, input);
  return input;
}

}  // namespace

bool is_there(const FrameStart& frame) { return fs::exists(frame.file); }
Origin origin_of(const FrameStart& frame) {
  require_there(frame.file);
  return {frame.file, physics_of_frame(frame.file)};
}

RunInput read_run(const fs::path& path) { return run_in(TomlFile::parse(path)); }

RunInput run_in(const TomlTable& file) {
  return read_with(file, [](const RunInput& input) { return origin_of_any(input.start); });
}

RunInput read_resumed_run(const fs::path& path, const fs::path& folder) {
  return read_with(TomlFile::parse(path), [&](const RunInput& input) -> std::optional<Origin> {
    const fs::path description = folder / "run.toml";
    if (is_gone(input) && fs::exists(description))
      return Origin{description.string(), read_physics(description)};
    return origin_of_any(input.start);
  });
}

bool is_there(const ModeStart& mode) { return fs::exists(mode.file); }
Origin origin_of(const ModeStart& mode) {
  require_there(mode.file);
  return {mode.file, static_cast<const Physics&>(read_mode(mode.file))};
}

std::string describe(const RunInput& input, std::string_view version) {
  TomlText toml(version);
  toml.value("model", input.model);
  write_surface(toml, input);
  write_material(toml, input.material, input.model);
  write_numerics(toml, input.numerics);
  write_times(toml, input.times, "frames");
  toml.value("finish", input.finish);
  toml.value("checkpoint_minutes", input.checkpoint_minutes);
  write_units(toml, input.units);
  return toml.text();
}

}  // namespace sbeh::studies
