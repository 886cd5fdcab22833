#include "studies/scan/scan_input.h"

#include "axisym/modes/stability_3d.h"
#include "studies/parameters/material_input.h"
#include "studies/parameters/material_number.h"
#include "studies/scan/scan_stack.h"

#include <fmt/format.h>

#include <algorithm>

namespace sbeh::studies {

bool StateGrid::has(model::Model model) const {
  return std::ranges::find(models, model) != models.end();
}

std::string stem(const PointKey& key) {
  return fmt::format("{}_{}_v{}_L{}", sbeh::name(key.model), name(key.branch), key.reduced_volume,
                     key.L);
}

std::filesystem::path point_file(const std::filesystem::path& folder, const PointKey& key,
                                 std::string_view ending) {
  return folder / "points" / (stem(key) + std::string(ending));
}

std::vector<PointKey> points_of(const StateGrid& grid) {
  std::vector<PointKey> keys;
  for (const double v : grid.reduced_volume)
    for (const double L : grid.L)
      for (const model::Model model : grid.models)
        for (const axisym::Branch branch : grid.branches) keys.push_back({v, L, model, branch});
  std::sort(keys.begin(), keys.end());
  return keys;
}

axisym::StationaryCase case_of(const StateGrid& grid, const PointKey& key) {
  return {.model = key.model,
          .branch = key.branch,
          .reduced_volume = key.reduced_volume,
          .material = grid.material.with_L1(key.L),
          .numerics = grid.numerics};
}

namespace {
void read_models_and_branches(const TomlTable& table, StateGrid& grid,
                              const std::vector<axisym::Branch>& branches) {
  grid.models = table.choices("models", rest_models, std::optional(grid.models));
  grid.branches = table.choices("branches", branches, std::optional(grid.branches));
}
}  // namespace

void read_grid(const TomlTable& table, StateGrid& grid,
               const std::vector<axisym::Branch>& branches) {
  grid.reduced_volume = table.grid("reduced_volume", reduced_volumes);
  grid.L = table.grid("L", above(0));
  read_models_and_branches(table, grid, branches);
}

void write_grid(TomlText& toml, const StateGrid& grid) {
  toml.value("reduced_volume", grid.reduced_volume);
  toml.value("L", grid.L);
  toml.value("models", grid.models);
  toml.value("branches", grid.branches);
}

std::size_t point_count(const ScanInput& input) {
  std::size_t count =
      input.reduced_volume.size() * input.L.size() * input.models.size() * input.branches.size();
  for (const ScanAxis& axis : input.axes) count *= axis.values.size();
  return count;
}

namespace {

constexpr std::size_t most_points = 1'000'000;  // 20 GB of profiles

// Whether the scan looks for what `beyond_fold` starts from.
void require_folds(const TomlTable& table, const ScanInput& input) {
  const auto& branches = input.branches;
  if (input.method != Method::newton || !input.has(model::Model::SBEH)
      || std::ranges::find(branches, axisym::Branch::oblate) == branches.end())
    table.fail("beyond_fold",
               "needs method = \"newton\", the model \"SBEH\" and the branch \"oblate\"");
}

constexpr const char* ssh_has_all_by_H0 =
    "needs models = [\"SBEH\"]: SSH, of uniform order, has all its shapes by "
    "spontaneous_curvature";

// reduced_volume and L, here or among `axes`, and what else stands there.
void read_axes(const TomlTable& table, ScanInput& input) {
  std::vector<std::string> names = MaterialNumber::names();
  names.emplace_back("reduced_volume");
  for (const char* key : {"reduced_volume", "L"}) table.has(key);  // asked for, in this order
  const TomlTable axes = table.table("axes");
  for (const std::string& name : names) axes.has(name);
  table.refuse_misspelt({"axes"});
  axes.refuse_misspelt(names);
  const auto where = [&](const char* key) -> const TomlTable& {
    if (!axes.has(key)) return table;
    table.refuse(key, "must not be given twice: it is among axes");
    return axes;
  };
  input.reduced_volume = where("reduced_volume").grid("reduced_volume", reduced_volumes);
  input.L = where("L").grid("L", above(0));
  for (const std::string& name : MaterialNumber::names())
    if (name != "L" && axes.has(name))
      input.axes.push_back({name, axes.grid(name, MaterialNumber::named(name)->allowed())});
  axes.reject_unknown_keys();
}

// What [material] does not say beside the axes: single numbers.
ParameterNames keys_of(const std::vector<ScanAxis>& axes) {
  ParameterNames keys;
  for (const ScanAxis& axis : axes) {
    const MaterialNumber& number = *MaterialNumber::named(axis.parameter);
    if (!is_of_order(number) && number.name() != "W2") keys.emplace_back(number.key());
  }
  return keys;
}

// Of each axis there is a material, and none says what [material] says.
void check_axes(const TomlTable& scan, const TomlTable& material, const ScanInput& input) {
  const TomlTable axes = scan.table("axes");
  for (const ScanAxis& axis : input.axes) {
    const MaterialNumber& number = *MaterialNumber::named(axis.parameter);
    for (const std::string_view key : keys_of({axis}))
      material.refuse(
          key, fmt::format("must not be given: {} is among the axes of the scan", axis.parameter));
    if (is_of_order(number) && number.key() != "potential" && input.has(model::Model::SSH))
      axes.fail(axis.parameter, ssh_has_all_by_H0);
    if (!is_there(number, input.material))
      axes.fail(axis.parameter, fmt::format("needs {} in [material]", number.key()));
    for (const double value : {axis.values.front(), axis.values.back()}) {
      const model::Material there = number.with(input.material, value);
      if (!is_bounded_below(there.potential))
        axes.fail(axis.parameter, fmt::format("is no potential bounded below at {}", value));
      try {
        for (const double L : {input.L.front(), input.L.back()}) there.with_L1(L).validate();
      } catch (const std::invalid_argument& error) {
        axes.fail(axis.parameter, fmt::format("is no material at {}: {}", value, error.what()));
      }
    }
  }
}

void read_scan_table(const TomlTable& table, ScanInput& input) {
  for (const model::Model flow : {model::Model::HelfrichLocal, model::Model::HelfrichGlobal})
    table.refuse_word("models", name(flow),
                      "must not be scanned: its states of rest are those of SSH");
  constexpr auto branches = values_of(axisym::Branch{});
  read_axes(table, input);
  read_models_and_branches(table, input, {branches.begin(), branches.end()});
  read_value(table, "method", input.method);
  table.refuse_misspelt({"method"});
  if (input.method != Method::flow)
    table.refuse("end_time", "must not be given without method = \"flow\"");
  input.flow_end_time = table.number("end_time", above(0), input.flow_end_time);
  input.beyond_fold = table.boolean("beyond_fold", input.beyond_fold);
  if (input.beyond_fold) require_folds(table, input);
  input.modes = table.integer("modes", 0, axisym::most_modes, input.modes);
  table.reject_unknown_keys();
  if (point_count(input) > most_points)
    table.fail("L",
               fmt::format("must have fewer values: that makes {} points with the other lists, "
                           "more than {}",
                           point_count(input), most_points));
}

// What is given of κ, κ_G, f does not go along with L.
void refuse_given(const TomlTable& material, const ScanInput& input) {
  for (const char* key : {"flexoelectric", "kappa", "kappa_gauss"}) {
    if (!input.material.has_functions() || !material.has(key)) continue;
    if (input.beyond_fold)
      material.fail(key, "must not be given with beyond_fold: sharp rims are known without it");
    if (input.has(model::Model::SSH)) material.fail(key, ssh_has_all_by_H0);
  }
  if (!input.beyond_fold) return;
  if (input.material.has_lipid_density())
    material.fail(
        "lipid_density",
        "must not be given with beyond_fold: sharp rims are known where the area is kept");
  if (input.material.area_difference.is_there())
    material.fail("area_difference",
                  "must not be given with beyond_fold: sharp rims are known without it");
  if (input.material.conserves_order())
    material.fail("order", "must be \"relaxing\" with beyond_fold: sharp rims are known with it");
}

}  // namespace

ScanInput read_scan(const std::filesystem::path& path) { return scan_in(TomlFile::parse(path)); }

ScanInput scan_in(const TomlTable& file) {
  const TomlTable scan = file.table("scan"), material = file.table("material"),
                  numerics = file.table("numerics");
  file.has("units");
  file.reject_unknown_keys();
  ScanInput input;
  input.units = read_units(file);
  read_scan_table(scan, input);
  material.measured_by(lengths_of(input.units));
  input.material = read_material_without_L(material, input.L);
  check_axes(scan, material, input);
  for (const ScanLayer& layer : layers_of(input)) refuse_given(material, layer.input);
  input.numerics = read_numerics<axisym::Numerics>(numerics);
  return input;
}

std::string describe(const ScanInput& input, std::string_view version) {
  TomlText toml(version);
  toml.table("scan");
  write_grid(toml, input);
  toml.value("method", input.method);
  if (input.method == Method::flow) toml.value("end_time", input.flow_end_time);
  if (input.method == Method::newton) toml.value("beyond_fold", input.beyond_fold);
  toml.value("modes", input.modes);
  if (!input.axes.empty()) toml.table("scan.axes");
  for (const ScanAxis& axis : input.axes) toml.value(axis.parameter, axis.values);
  write_material_without_L(toml, input.material, keys_of(input.axes));
  write_numerics(toml, input.numerics);
  write_units(toml, input.units);
  return toml.text();
}

}  // namespace sbeh::studies
