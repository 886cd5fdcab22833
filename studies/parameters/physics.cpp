#include "studies/parameters/physics.h"

#include "studies/parameters/material_input.h"

#include <fmt/format.h>

namespace sbeh::studies {

namespace {

std::string text_of(const Physics& physics) {
  std::string text = fmt::format("model = {}", as_toml(physics.model));
  for_each_parameter(physics.material, [&](const model::Parameter& parameter, const auto& value) {
    text += fmt::format(", {} = {}", parameter.name, as_toml(value));
  });
  return text;
}

// Nothing that changes the energy by itself is left to a default.
void require_said(const TomlTable& file, bool model_is_named, const TomlTable& material,
                  const std::string& place) {
  if (!model_is_named)
    file.fail("model",
              fmt::format("missing; {} does not say with which model it was computed", place));
  bool elastic = material.has("L");
  for (const char* key : {"L1", "L2", "L3"}) elastic = elastic || material.has(key);
  if (!elastic)
    material.fail("L",
                  fmt::format("missing; {} does not say with which material it was computed: give "
                              "L, and all else that is not the default",
                              place));
}

}  // namespace

Physics read_physics(const TomlTable& file, const std::optional<model::Model>& named,
                     const TomlTable& material,
                     const std::function<std::optional<Origin>()>& origin) {
  if (named && is_complete(material, *named)) return {*named, read_material(material, *named)};
  const std::optional<Origin> from = origin();
  const bool unknown = from && !from->physics;
  if (unknown) require_said(file, named.has_value(), material, from->place);
  const Physics absent = from && !unknown ? *from->physics : Physics{};
  const model::Model model = named.value_or(absent.model);
  return {model, read_material(material, model, absent.material)};
}

Physics read_physics(const std::filesystem::path& description) {
  const TomlTable file = TomlFile::parse(description);
  const auto model = file.choice("model", values_of(model::Model{}));
  return {model, read_material(file.table("material"), model)};
}

std::vector<Difference> differences(const Physics& there, const Physics& here) {
  std::vector<Difference> found;
  if (there.model != here.model)
    found.push_back({"model", as_toml(there.model), as_toml(here.model)});
  const bool own_drag = has_own_drag(there.model) || has_own_drag(here.model);
  for (const Difference& of :
       differences(there.material, here.material, own_drag ? parameters_of_drag : ParameterNames{}))
    found.push_back({"material." + of.name, of.first, of.second});
  return found;
}

std::optional<std::string> remark_on(const Origin& origin, const Physics& here,
                                     const std::function<StartEnergies()>& energies) {
  if (!origin.physics)
    return fmt::format("{}: it is not known with what it was computed; it goes on with {}",
                       origin.place, text_of(here));
  const std::vector<Difference> changes = differences(*origin.physics, here);
  if (changes.empty()) return {};
  const auto [there_energy, here_energy] = energies();
  return fmt::format(
      "{}: {}; the energy of this start is {:.10g} with what it was computed with, {:.10g} with "
      "what "
      "it goes on with",
      origin.place, text_of(changes), there_energy, here_energy);
}

}  // namespace sbeh::studies
