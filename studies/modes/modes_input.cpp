#include "studies/modes/modes_input.h"

#include "studies/parameters/material_input.h"

#include <fmt/format.h>

#include <cmath>

namespace sbeh::studies {

namespace {

void read_state(const TomlTable& table, ModesInput& input) {
  axisym::StationaryCase& state = input.state;
  if (table.has("scan")) input.scan = table.path("scan");
  state.model = table.choice("model", rest_models, std::optional(state.model));
  read_value(table, "branch", state.branch);
  state.reduced_volume = table.number("reduced_volume", reduced_volumes);
  if (state.reduced_volume == 1) table.fail("reduced_volume", no_sphere);
  state.material.L1 = table.number("L", above(0));
}

model::Material read_material(const TomlTable& table, const ModesInput& input) {
  return read_material_without_L(table, {input.state.L()}, "modes, where L comes from [modes]")
      .with_L1(input.state.L());
}

// A description names both; they may differ in what does not move the state.
void require_material_of_scan(const TomlTable& table, const ModesInput& input,
                              const model::Material& asked) {
  const auto changes = differences(input.state.material, asked, parameters_of_motion);
  if (!changes.empty())
    table.fail(changes.front().name,
               fmt::format("must be as in the scan {}, {}: the state is one of that material",
                           input.scan, changes.front().first));
}

void read_thermal_energy(const TomlTable& file, const TomlTable& modes, ModesInput& input) {
  modes.measured_by(read_scales(file, input.units, input.state.material, input.state.model));
  input.thermal_energy = modes.number("fluctuations", at_least(0), input.thermal_energy);
}

}  // namespace

ScanRow row_of(const ModesInput& input) {
  const axisym::StationaryCase& s = input.state;
  return {{s.reduced_volume, s.L(), s.model, s.branch}, input.scan};
}

void take_from_scan(ModesInput& input) {
  input.state.material = origin_of(row_of(input)).physics->material;
}

ModesInput read_modes(const std::filesystem::path& path) {
  const TomlTable file = TomlFile::parse(path);
  const TomlTable modes = file.table("modes"), material = file.table("material"),
                  numerics = file.table("numerics");
  file.has("units");
  file.reject_unknown_keys();
  ModesInput input;
  input.units = read_units(file);
  read_state(modes, input);
  input.largest_m = modes.integer("largest_m", 0, largest_mode_m, input.largest_m);
  input.number = modes.integer("number", 1, most_mode_number, input.number);
  modes.has("fluctuations");
  modes.reject_unknown_keys();
  material.measured_by(lengths_of(input.units));
  const model::Material asked = read_material(material, input);
  if (input.scan.empty()) {
    input.state.material = asked;
    input.state.numerics = read_numerics<axisym::Numerics>(numerics);
    read_thermal_energy(file, modes, input);
    return input;
  }
  if (file.has("numerics"))
    file.refuse("numerics", "must not be given together with scan, whose states are taken");
  take_from_scan(input);
  if (file.has("material")) {
    require_material_of_scan(material, input, asked);
    input.state.material = asked;
  }
  read_thermal_energy(file, modes, input);
  return input;
}

axisym::StationaryCase described_state(const std::filesystem::path& description) {
  const TomlTable file = TomlFile::parse(description);
  ModesInput input;
  read_state(file.table("modes"), input);
  input.state.material = read_material(file.table("material"), input);
  return input.state;
}

std::string text_of(const axisym::StationaryCase& of) {
  return fmt::format("{} {}, V_r = {}, L = {}", sbeh::name(of.model), name(of.branch),
                     of.reduced_volume, of.L());
}

ModesCost cost_of(const ModesInput& input) {
  const axisym::StationaryCase& s = input.state;
  const bool parities = is_symmetric(s.branch);  // each over half of the state
  const int modes = (parities ? 2 : 1) * (input.largest_m + 1) * input.number;
  return {
      .modes = modes,
      .seconds = (0.1 + (parities ? 0.045 : 0.14) * modes) * std::sqrt(s.numerics.elements / 48.),
      .megabytes = 0.18 * modes};
}

std::string describe(const ModesInput& input, std::string_view version) {
  const axisym::StationaryCase& s = input.state;
  TomlText toml(version);
  toml.table("modes");
  if (!input.scan.empty()) toml.value("scan", input.scan);
  toml.value("model", s.model);
  toml.value("branch", s.branch);
  toml.value("reduced_volume", s.reduced_volume);
  toml.value("L", s.L());
  toml.value("largest_m", input.largest_m);
  toml.value("number", input.number);
  toml.value("fluctuations", input.thermal_energy);
  write_material_without_L(toml, s.material);
  if (input.scan.empty()) write_numerics(toml, s.numerics);
  write_units(toml, input.units);
  return toml.text();
}

}  // namespace sbeh::studies
