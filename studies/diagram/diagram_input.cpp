#include "studies/diagram/diagram_input.h"

#include "axisym/diagram/traced_branches.h"
#include "axisym/modes/stability_3d.h"
#include "axisym/stationary/classical_branches.h"
#include "studies/io/toml_reader.h"
#include "studies/io/toml_text.h"
#include "studies/parameters/parameters.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace sbeh::studies {

axisym::Numerics DiagramInput::numerics() const {
  axisym::Numerics numerics;
  numerics.elements = elements;
  return numerics;
}

model::Material DiagramInput::material(double value) const {
  model::Material material = axisym::classical_material();
  if (kind == DiagramKind::spontaneous_curvature)
    material.spontaneous_curvature = 0 - value;  // no −0
  else
    material.area_difference = {kind == DiagramKind::area_difference
                                    ? stiffness_ratio
                                    : std::numeric_limits<double>::infinity(),
                                -8 * std::numbers::pi * value};
  return material;
}

axisym::Line DiagramInput::line(double value) const {
  const model::Material of = material(value);
  return {.material = of,
          .model = model::Model::SSH,
          .from = {axisym::nearly_round, of.L1},
          .to = {least_volume, of.L1}};
}

std::vector<double> usual_values(DiagramKind kind, int count) {
  constexpr Interval ranges[]{between(-3, 3), between(0.5, 1.6),
                              between(0.4, 1.9)};  // of names(kind)
  const auto& [low, high, open] = ranges[std::size_t(kind)];
  std::vector<double> values;
  values.reserve(std::size_t(count));
  for (int k = 0; k < count; ++k)
    values.push_back(count == 1 ? low : low + (high - low) * k / (count - 1));
  return values;
}

namespace {

constexpr double largest_value = 10;
constexpr int most_values = 1000;

std::vector<double> read_values(const TomlTable& table, DiagramKind kind) {
  if (!table.has("values")) return usual_values(kind);
  std::vector<double> values =
      table.numbers("values", model::between(-largest_value, largest_value));
  std::ranges::sort(values);
  if (values.empty() || values.size() > most_values)
    table.fail("values", fmt::format("must be 1 to {} numbers", most_values));
  if (std::ranges::adjacent_find(values) != values.end())
    table.fail("values", "must be different from each other");
  return values;
}

}  // namespace

DiagramInput read_diagram(const std::filesystem::path& path) {
  const TomlTable file = TomlFile::parse(path);
  const TomlTable table = file.table("diagram");
  file.reject_unknown_keys();
  DiagramInput input;
  input.kind = table.choice("kind", values_of(input.kind));
  input.values = read_values(table, input.kind);
  if (input.kind != DiagramKind::area_difference)
    table.refuse("stiffness_ratio", "must not be given without kind = \"area-difference\"");
  input.stiffness_ratio = table.number("stiffness_ratio", above(0), input.stiffness_ratio);
  input.least_volume = table.number("least_volume", model::between(0.1, 0.98), input.least_volume);
  input.modes = table.integer("modes", 0, axisym::most_modes, input.modes);
  input.elements = table.integer("elements", 16, 512, input.elements);
  table.reject_unknown_keys();
  return input;
}

std::string describe(const DiagramInput& input, std::string_view version) {
  TomlText toml(version);
  toml.table("diagram");
  toml.value("kind", input.kind);
  toml.value("values", input.values);
  if (input.kind == DiagramKind::area_difference)
    toml.value("stiffness_ratio", input.stiffness_ratio);
  toml.value("least_volume", input.least_volume);
  toml.value("modes", input.modes);
  toml.value("elements", input.elements);
  return toml.text();
}

}  // namespace sbeh::studies
