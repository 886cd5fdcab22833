#include "studies/stability/stability_input.h"

#include "meshing/resolution.h"
#include "studies/parameters/material_input.h"

#include <fmt/format.h>

#include <algorithm>

namespace sbeh::studies {

namespace {

const ParameterNames run_keys{"largest_step", "tolerance"};
constexpr int largest_perturbation_degree = 8;

// All that can be perturbed and still be called a small displacement of a surface with radius 1.
constexpr double largest_amplitude = 0.3;

std::vector<meshing::Harmonic> read_perturbations(const TomlTable& table,
                                                  std::vector<meshing::Harmonic> absent) {
  if (!table.has("perturbations")) return absent;
  auto modes = table.harmonics("perturbations", largest_perturbation_degree);
  for (const meshing::Harmonic& mode : modes) {
    if (mode.m < 1)
      table.fail("perturbations",
                 fmt::format("must have m >= 1, not {}: with m = 0 the axisymmetric solver is "
                             "enough, and m < 0 is m > 0 turned about the axis",
                             mode.m));
    if (mode.m == 1 && (mode.l == 1 || mode.l % 2 == 0))
      table.fail("perturbations",
                 fmt::format("must have l = 3, 5 or 7 where m = 1, not {}: that mostly {} the "
                             "surface",
                             mode.l, mode.l == 1 ? "shifts" : "turns"));
    if (!(mode.amplitude > 0 && mode.amplitude <= largest_amplitude))
      table.fail("perturbations", fmt::format("must have amplitudes > 0 and <= {}, not {}",
                                              largest_amplitude, mode.amplitude));
  }
  return modes;
}

void read_states(const TomlTable& table, StabilityInput& input) {
  read_grid(table, input, {axisym::Branch::oblate, axisym::Branch::prolate});
  if (input.reduced_volume.back() == 1)
    table.fail("reduced_volume", "must be < 1: there is only the sphere, which cannot move");
  input.perturbations = read_perturbations(table, input.perturbations);
  input.start = table.choice("start", values_of(input.start), std::optional(input.start));
  table.reject_unknown_keys();
}

void read_surface(const TomlTable& table, StabilityInput& input) {
  input.triangles = table.integer("triangles", meshing::fewest_triangles, meshing::most_triangles,
                                  input.triangles);
  if (table.has("coarser"))
    input.coarser = table.integer("coarser", meshing::fewest_triangles, input.triangles - 1);
  input.end_time = table.number("end", above(0), input.end_time);
  read_some(table, input.numerics_3d, run_keys);
  check(table, input.numerics_3d);
}

}  // namespace

StabilityInput::StabilityInput() {
  // Perturbations are hardly larger than the tolerance: what is left of a rate is the error of steps that it lets be long.
  numerics_3d.integrator = surface3d::Integrator::two_step;
  numerics_3d.tolerance = 1e-3;
  numerics_3d.largest_step = 0.1;
}

std::string stem(const StabilityKey& key) {
  return fmt::format("{}_Y{}{}", stem(PointKey(key)), key.l, key.m);
}

std::vector<StabilityKey> keys_of(const StabilityInput& input) {
  std::vector<StabilityKey> keys;
  for (const PointKey& point : points_of(input)) {
    const bool once = point.model == model::Model::SSH && input.material.residual_stiffness == 0
                   && !input.material.has_given();
    if (once && point.L != input.L.back()) continue;
    for (const meshing::Harmonic& mode : input.perturbations)
      keys.push_back({point, mode.l, mode.m});
  }
  std::sort(keys.begin(), keys.end());
  return keys;
}

meshing::Harmonic perturbation_of(const StabilityInput& input, const StabilityKey& key) {
  return *std::ranges::find_if(input.perturbations, [&](const meshing::Harmonic& mode) {
    return mode.l == key.l && mode.m == key.m;
  });
}

StabilityInput read_stability(const std::filesystem::path& path) {
  const TomlTable file = TomlFile::parse(path);
  const TomlTable states = file.table("stability"), surface = file.table("surface3d"),
                  material = file.table("material"), numerics = file.table("numerics");
  file.has("units");
  file.reject_unknown_keys();
  StabilityInput input;
  input.units = read_units(file);
  read_states(states, input);
  read_surface(surface, input);
  material.measured_by(lengths_of(input.units));
  input.material = read_material_without_L(material, input.L,
                                           "a study of stability, where L comes from [stability]");
  input.numerics = read_numerics<axisym::Numerics>(numerics);
  return input;
}

std::string describe(const StabilityInput& input, std::string_view version) {
  TomlText toml(version);
  toml.table("stability");
  write_grid(toml, input);
  toml.value("perturbations", input.perturbations);
  toml.value("start", input.start);
  toml.table("surface3d");
  toml.value("triangles", input.triangles);
  if (input.coarser > 0) toml.value("coarser", input.coarser);
  toml.value("end", input.end_time);
  write_some(toml, input.numerics_3d, run_keys);
  write_material_without_L(toml, input.material);
  write_numerics(toml, input.numerics);
  write_units(toml, input.units);
  return toml.text();
}

}  // namespace sbeh::studies
