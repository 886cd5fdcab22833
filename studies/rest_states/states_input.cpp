#include "studies/rest_states/states_input.h"

#include "meshing/resolution.h"
#include "studies/evolution/frame_file.h"
#include "studies/evolution/start_shape.h"
#include "studies/parameters/material_input.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace sbeh::studies {

namespace {

constexpr const char* no_sphere_here =
    "must be < 1: on the sphere area and volume are one condition, not two";

void read_start(const TomlTable& table, StatesInput& input) {
  const std::string given = table.has("scan")  ? "scan"
                          : table.has("frame") ? "frame"
                          : table.has("mesh")  ? "mesh"
                                               : "branch";
  input.start = *value_named<StatesStart>(given);
  const std::string one =
      fmt::format("must not be given together with {}: a state has one start", given);
  for (const char* other : {"frame", "mesh"})
    if (given != other) table.refuse(other, one);
  if (brings_its_mesh(input.start))
    table.refuse("branch", one);
  else
    read_value(table, "branch", input.branch);
  if (given != "branch") input.file = table.path(given);
}

// What the file does not say of model, V_r and L, and the material.
struct Absent {
  std::optional<model::Model> model;
  std::optional<std::vector<double>> reduced_volume, L;
  std::optional<model::Material> material;
};

Absent of_frame(const std::string& file) {
  const FlowMoment frame = read_frame(file);
  Absent of;
  const double volume =
      frame.target.volume / std::pow(frame.target.area / (4 * std::numbers::pi), 1.5);
  of.reduced_volume = {volume / (4 * std::numbers::pi / 3)};
  const auto physics = physics_of_frame(file);
  if (!physics) return of;
  of.model = physics->model;
  of.material = physics->material;
  if (physics->material == physics->material.with_L(physics->material.L1))
    of.L = {physics->material.L1};
  return of;
}

void read_places(const TomlTable& table, const Absent& absent, StatesInput& input) {
  input.reduced_volume = table.grid("reduced_volume", reduced_volumes, absent.reduced_volume);
  if (!(input.reduced_volume.back() < 1)) table.fail("reduced_volume", no_sphere_here);
  input.L = table.grid("L", above(0), absent.L);
}

std::size_t power_of(FollowedParameter parameter) {
  return std::size_t(parameter) - std::size_t(FollowedParameter::potential_1) + 1;
}

Interval range_of(FollowedParameter parameter) {
  switch (parameter) {
    case FollowedParameter::reduced_volume:
      return reduced_volumes;
    case FollowedParameter::L:
      return above(0);
    case FollowedParameter::k0:
      return at_least(0);
    default:
      return model::any_number;
  }
}

// Both ends are materials: what lies between is one then, too, since all bounds are linear.
void check_end(const TomlTable& table, const StatesInput& input, const FollowInput& follow) {
  const model::Material end = at_value(input, follow.parameter, follow.to).material;
  const auto& powers = end.potential.coefficients();
  std::size_t degree = powers.size();
  while (degree > 0 && powers[degree - 1] == 0) --degree;
  if (degree > 1 && (degree % 2 == 0 || powers[degree - 1] < 0))
    table.fail("to",
               "the potential must be bounded below: its highest power even, with a "
               "coefficient > 0");
}

constexpr const char* of_one_state =
    "belongs to one state: reduced_volume and L of [states] must be one value each";

SearchInput read_search(const TomlTable& table, const StatesInput& input) {
  if (places_of(input).size() != 1) table.fail("most_states", of_one_state);
  SearchInput search;
  search.most_states = table.integer("most_states", 2, 1000, search.most_states);
  search.reach =
      table.number("reach", Interval{.low = 0, .high = 1, .low_open = true}, search.reach);
  table.reject_unknown_keys();
  return search;
}

FollowInput read_follow(const TomlTable& table, const StatesInput& input) {
  if (places_of(input).size() != 1) table.fail("parameter", of_one_state);
  FollowInput follow;
  read_value(table, "parameter", follow.parameter);
  follow.to = table.number("to", range_of(follow.parameter));
  if (follow.parameter == FollowedParameter::reduced_volume && follow.to == 1)
    table.fail("to", no_sphere_here);
  if (follow.to == value_of(input, follow.parameter))
    table.fail("to", fmt::format("must not be the {} of the first state", name(follow.parameter)));
  if (follow.parameter >= FollowedParameter::potential_1) {
    if (!has_free_order(input.model))
      table.fail("parameter", "belongs to model = 'SBEH': the order of SSH is 2/3 everywhere");
    check_end(table, input, follow);
  }
  follow.switches = table.boolean("switch", follow.switches);
  follow.longest_step = table.number(
      "longest_step", Interval{.low = 0, .high = 1, .low_open = true}, follow.longest_step);
  follow.most_states = table.integer("most_states", 2, 1000, follow.most_states);
  follow.most_negative = table.integer("most_negative", 0, 100, follow.most_negative);
  table.reject_unknown_keys();
  return follow;
}

// A description names both; they may differ in what does not move the states.
void take_material(const TomlTable& file, const TomlTable& material, const model::Material& there,
                   StatesInput& input) {
  const model::Material of_start = without_L(there);
  if (file.has("material")) {
    const auto changes = differences(of_start, input.material, parameters_of_motion);
    if (!changes.empty())
      material.fail(changes.front().name,
                    fmt::format("must be as in {} {}, {}: the states are of that material",
                                name(input.start), input.file, changes.front().first));
    return;
  }
  input.material = of_start;
}

}  // namespace

model::Material without_L(model::Material material) {
  const model::Material absent;
  material.L1 = absent.L1;
  material.L2 = absent.L2;
  material.L3 = absent.L3;
  return material;
}

bool brings_its_mesh(StatesStart start) {
  return start == StatesStart::frame || start == StatesStart::mesh;
}

std::vector<StatePlace> places_of(const StatesInput& input) {
  std::vector<StatePlace> places;
  for (const double L : input.L)
    for (const double v : input.reduced_volume) places.push_back({int(places.size()) + 1, {v, L}});
  return places;
}

double value_of(const StatesInput& input, FollowedParameter parameter) {
  switch (parameter) {
    case FollowedParameter::reduced_volume:
      return input.reduced_volume.front();
    case FollowedParameter::L:
      return input.L.front();
    case FollowedParameter::H0:
      return input.material.spontaneous_curvature;
    case FollowedParameter::k0:
      return input.material.residual_stiffness;
    default: {
      const auto& powers = input.material.potential.coefficients();
      const std::size_t power = power_of(parameter);
      return power < powers.size() ? powers[power] : 0;
    }
  }
}

StatesInput at_value(StatesInput input, FollowedParameter parameter, double value) {
  switch (parameter) {
    case FollowedParameter::reduced_volume:
      input.reduced_volume = {value};
      break;
    case FollowedParameter::L:
      input.L = {value};
      break;
    case FollowedParameter::H0:
      input.material.spontaneous_curvature = value;
      break;
    case FollowedParameter::k0:
      input.material.residual_stiffness = value;
      break;
    default: {
      auto powers = input.material.potential.coefficients();
      const std::size_t power = power_of(parameter);
      powers.resize(std::max(powers.size(), power + 1));
      powers[power] = value;
      input.material.potential = model::Potential(powers);
    }
  }
  return input;
}

ScanRow row_of(const StatesInput& input, const axisym::PlanePoint& at) {
  return {{at.reduced_volume, at.L, input.model, input.branch}, input.file};
}

StatesInput read_states(const std::filesystem::path& path) {
  const TomlTable file = TomlFile::parse(path);
  const TomlTable states = file.table("states"), material = file.table("material"),
                  follow = file.table("follow"), search = file.table("search"),
                  numerics = file.table("numerics");
  file.has("units");
  file.reject_unknown_keys();
  StatesInput input;
  input.units = read_units(file);
  read_start(states, input);
  Absent absent;
  if (input.start == StatesStart::frame) absent = of_frame(input.file);
  input.model =
      states.choice("model", rest_models, absent.model ? absent.model : std::optional(input.model));
  read_places(states, absent, input);
  states.measured_by(lengths_of(input.units));
  if (states.has("perturbation"))
    input.perturbation = states.harmonics("perturbation", largest_degree);
  if (brings_its_mesh(input.start))
    states.refuse("triangles", "must not be given: the surface of a file keeps its triangles");
  else
    input.triangles = states.integer("triangles", meshing::fewest_triangles,
                                     meshing::most_triangles, input.triangles);
  input.eigenpairs = states.integer("eigenpairs", 0, most_eigenpairs, input.eigenpairs);
  input.rates = states.integer("rates", 0, most_eigenpairs, input.rates);
  states.reject_unknown_keys();
  material.measured_by(lengths_of(input.units));
  input.material = read_material_without_L(material, "states, where L comes from [states]");
  if (input.start == StatesStart::scan)
    absent.material = origin_of(row_of(input, places_of(input).front().at)).physics->material;
  if (absent.material) take_material(file, material, *absent.material, input);
  if (file.has("follow")) input.follow = read_follow(follow, input);
  if (file.has("search")) {
    if (input.follow)
      file.refuse(
          "search",
          "must not be given together with [follow]: search first, then follow from a frame");
    input.search = read_search(search, input);
  }
  if (input.start == StatesStart::branch)
    input.numerics = read_numerics<axisym::Numerics>(numerics);
  else if (file.has("numerics"))
    file.refuse("numerics", "belongs to states that start from a branch");
  return input;
}

double seconds_of(const StatesInput& input, int triangles) {
  return double(places_of(input).size()) * 1.3 * std::pow(triangles / 320., 1.15)
       * (input.search ? 10. * input.search->most_states : 1.)
       * (1 + input.eigenpairs / 20. + (input.rates > 0 ? 3 : 0)) * (input.follow ? 30 : 1);
}

std::string describe(const StatesInput& input, std::string_view version) {
  TomlText toml(version);
  toml.table("states");
  toml.value("model", input.model);
  if (!brings_its_mesh(input.start)) toml.value("branch", input.branch);
  if (input.start != StatesStart::branch)
    toml.value(name(input.start),
               input.file_in_description.empty() ? input.file : input.file_in_description);
  toml.value("reduced_volume", input.reduced_volume);
  toml.value("L", input.L);
  if (!input.perturbation.empty()) toml.value("perturbation", input.perturbation);
  if (!brings_its_mesh(input.start)) toml.value("triangles", input.triangles);
  toml.value("eigenpairs", input.eigenpairs);
  toml.value("rates", input.rates);
  if (input.follow) {
    toml.table("follow");
    toml.value("parameter", input.follow->parameter);
    toml.value("to", input.follow->to);
    toml.value("switch", input.follow->switches);
    toml.value("longest_step", input.follow->longest_step);
    toml.value("most_states", input.follow->most_states);
    toml.value("most_negative", input.follow->most_negative);
  }
  if (input.search) {
    toml.table("search");
    toml.value("most_states", input.search->most_states);
    toml.value("reach", input.search->reach);
  }
  write_material_without_L(toml, input.material);
  if (input.start == StatesStart::branch) write_numerics(toml, input.numerics);
  write_units(toml, input.units);
  return toml.text();
}

}  // namespace sbeh::studies
