#include "studies/scan/scan_input.h"

#include "axisym/domains.h"
#include "axisym/modes/stability_3d.h"
#include "studies/parameters/material_input.h"
#include "studies/parameters/material_number.h"
#include "studies/scan/domain_start.h"
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
          .interfaces = grid.interfaces,
          .material = grid.material.with_L1(key.L),
          .numerics = grid.numerics};
}

namespace {

// Whether `branches` is no list but the word all.
bool asks_for_all(const TomlTable& table) {
  const auto word = [&]() -> std::string {
    try {
      return table.text("branches", "");
    } catch (const InputError&) {
      return "";  // a list
    }
  }();
  if (!word.empty() && word != "all") table.fail("branches", "must be a list, or \"all\"");
  return word == "all";
}

void read_models_and_branches(const TomlTable& table, StateGrid& grid,
                              const std::vector<axisym::Branch>& branches) {
  grid.models = table.choices("models", rest_models, std::optional(grid.models));
  grid.branches = asks_for_all(table)
                    ? branches
                    : table.choices("branches", branches, std::optional(grid.branches));
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

const char* key_of(const OrderPattern& pattern) {
  return pattern.formula.empty() ? "domains" : "order_formula";
}

// Of states that begin with an order of several phases.
void check_domains(const TomlTable& table, const ScanInput& input) {
  const char* key = key_of(input.start_order);
  if (input.has(model::Model::SSH))
    table.fail(key, "needs models = [\"SBEH\"]: the order of SSH is uniform");
  if (input.method != Method::newton) table.fail(key, "needs method = \"newton\"");
  if (input.beyond_fold)
    table.fail(key, "must not be given with beyond_fold: sharp rims are known of one phase");
  if (!std::ranges::all_of(input.branches, [](axisym::Branch b) { return is_symmetric(b); }))
    table.fail(key, "begins from spheroids: branches must be \"oblate\" or \"prolate\"");
  if (input.reduced_volume.back() == 1)
    table.fail("reduced_volume", fmt::format("must be < 1 with {}", key));
}

// How many interfaces the start has, which all states keep.
void count_interfaces(const TomlTable& scan, ScanInput& input) {
  if (!input.start_order.is_there()) return;
  const char* key = key_of(input.start_order);
  if (!input.material.conserves_order())
    scan.fail(key, "needs order = \"conserved\" and a mean_order in [material]");
  const auto count = [&](const ScanInput& layer) {
    const PointKey first{layer.reduced_volume.back(), layer.L.front(), model::Model::SBEH,
                         layer.branches.front()};
    try {
      return int(
          axisym::interfaces(spheroid_with(case_of(layer, first), layer.start_order)).size());
    } catch (const std::invalid_argument& error) {
      scan.fail(key, error.what());
    }
  };
  input.interfaces = count(input);
  if (input.interfaces == 0)
    scan.fail(key, fmt::format("must make orders that differ by {} at least",
                               model::Domains::least_contrast));
  for (const ScanAxis& axis : input.axes)
    if (axis.parameter == "mean_order")
      for (const ScanLayer& layer : layers_of(input))
        if (count(layer.input) != input.interfaces)
          scan.fail(key, "must make the same number of domains at each mean_order");
}

// What is traced.
void read_further(const TomlTable& table, ScanInput& input) {
  constexpr int most = 10;
  if (table.has("further")) input.further = table.integer("further", 0, most);
  if (input.method == Method::newton) return;
  if (input.further) table.fail("further", "needs method = \"newton\"");
  if (std::ranges::find(input.branches, axisym::Branch::pear) != input.branches.end())
    table.fail("branches", "needs method = \"newton\" for the pear");
}

void check_traced(const TomlTable& scan, const ScanInput& input) {
  const model::AreaDifference& ad = input.material.area_difference;
  if (!ad.is_there() || ad.compliance() > 0) return;
  constexpr const char* reason = "needs an area_difference of finite stiffness: see sbeh diagram";
  if (input.further) scan.fail("further", reason);
  if (std::ranges::find(input.branches, axisym::Branch::pear) != input.branches.end())
    scan.fail("branches", std::string(reason) + " for the pear");
}

void read_scan_table(const TomlTable& table, ScanInput& input) {
  for (const model::Model flow : {model::Model::HelfrichLocal, model::Model::HelfrichGlobal})
    table.refuse_word("models", name(flow),
                      "must not be scanned: its states of rest are those of SSH");
  constexpr auto branches = values_of(axisym::Branch{});
  read_axes(table, input);
  read_models_and_branches(table, input, {branches.begin(), branches.end()});
  read_value(table, "method", input.method);
  read_further(table, input);
  table.refuse_misspelt({"method"});
  if (input.method != Method::flow)
    table.refuse("end_time", "must not be given without method = \"flow\"");
  input.flow_end_time = table.number("end_time", above(0), input.flow_end_time);
  input.beyond_fold = table.boolean("beyond_fold", input.beyond_fold);
  if (input.beyond_fold) require_folds(table, input);
  input.modes = table.integer("modes", 0, axisym::most_modes, input.modes);
  input.start_order = read_order_pattern(table, true);
  table.reject_unknown_keys();
  if (input.start_order.is_there()) check_domains(table, input);
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
  check_traced(scan, input);
  for (const ScanLayer& layer : layers_of(input)) refuse_given(material, layer.input);
  input.numerics = read_numerics<axisym::Numerics>(numerics);
  count_interfaces(scan, input);
  return input;
}

std::string describe(const ScanInput& input, std::string_view version) {
  TomlText toml(version);
  toml.table("scan");
  write_grid(toml, input);
  toml.value("method", input.method);
  if (input.method == Method::flow) toml.value("end_time", input.flow_end_time);
  if (input.method == Method::newton) toml.value("beyond_fold", input.beyond_fold);
  if (input.further) toml.value("further", *input.further);
  toml.value("modes", input.modes);
  write_order_pattern(toml, input.start_order);
  if (!input.axes.empty()) toml.table("scan.axes");
  for (const ScanAxis& axis : input.axes) toml.value(axis.parameter, axis.values);
  write_material_without_L(toml, input.material, keys_of(input.axes));
  write_numerics(toml, input.numerics);
  write_units(toml, input.units);
  return toml.text();
}

}  // namespace sbeh::studies
