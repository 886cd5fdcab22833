#include "studies/rest_states/states_input.h"

#include "meshing/resolution.h"
#include "studies/evolution/frame_file.h"
#include "studies/evolution/start_shape.h"
#include "studies/parameters/material_input.h"
#include "studies/parameters/material_number.h"

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
  if (physics->material.L1 > 0) of.L = {physics->material.L1};
  return of;
}

void read_places(const TomlTable& table, const Absent& absent, StatesInput& input) {
  input.reduced_volume = table.grid("reduced_volume", reduced_volumes, absent.reduced_volume);
  if (!(input.reduced_volume.back() < 1)) table.fail("reduced_volume", no_sphere_here);
  input.L = table.grid("L", above(0), absent.L);
}

std::vector<std::string> followed_parameters() {
  std::vector<std::string> names = MaterialNumber::names();
  names.insert(names.begin(), followed_volume);
  return names;
}

// Both ends are materials: what lies between is one then, too, since all bounds are linear.
void check_end(const TomlTable& table, const StatesInput& input, const FollowInput& follow) {
  const StatesInput end = at_value(input, follow.parameter, follow.to);
  if (!is_bounded_below(end.material.potential))
    table.fail("to",
               "the potential must be bounded below: its highest power even, with a "
               "coefficient > 0");
  try {
    end.material.with_L1(end.L.front()).validate();
  } catch (const std::invalid_argument& error) {
    table.fail("to", fmt::format("is no material there: {}", error.what()));
  }
}

void require_there(const TomlTable& table, const StatesInput& input, const MaterialNumber& number) {
  if (!has_free_order(input.model) && is_of_order(number))
    table.fail("parameter", "belongs to model = 'SBEH': the order of SSH is 2/3 everywhere");
  if (!is_there(number, input.material))
    table.fail("parameter",
               fmt::format("needs {} in [material], where its way begins", number.key()));
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
  follow.parameter = table.word("parameter", followed_parameters(), follow.parameter);
  const MaterialNumber* number = MaterialNumber::named(follow.parameter);
  table.measured_by(lengths_of(input.units));
  follow.to = table.number_as(number ? number->key() : follow.parameter, "to",
                              number ? number->allowed() : reduced_volumes);
  if (!number && follow.to == 1) table.fail("to", no_sphere_here);
  if (follow.to == value_of(input, follow.parameter))
    table.fail("to", fmt::format("must not be the {} of the first state", follow.parameter));
  if (number) {
    require_there(table, input, *number);
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

double value_of(const StatesInput& input, const std::string& parameter) {
  const MaterialNumber* number = MaterialNumber::named(parameter);
  return number ? number->of(input.material.with_L1(input.L.front()))
                : input.reduced_volume.front();
}

StatesInput at_value(StatesInput input, const std::string& parameter, double value) {
  const MaterialNumber* number = MaterialNumber::named(parameter);
  if (!number) {
    input.reduced_volume = {value};
    return input;
  }
  const model::Material there = number->with(input.material.with_L1(input.L.front()), value);
  input.L = {there.L1};
  input.material = without_L(there);
  return input;
}

ScanRow row_of(const StatesInput& input, const axisym::PlanePoint& at) {
  return {{at.reduced_volume, at.L, input.model, input.branch}, input.file};
}

StatesInput read_states(const std::filesystem::path& path) {
  return states_in(TomlFile::parse(path));
}

StatesInput states_in(const TomlTable& file) {
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
  input.symmetry = read_symmetry(states, "symmetry");
  input.eigenpairs = states.integer("eigenpairs", 0, most_eigenpairs, input.eigenpairs);
  input.rates = states.integer("rates", 0, most_eigenpairs, input.rates);
  input.passes = states.boolean("passes", input.passes);
  states.reject_unknown_keys();
  material.measured_by(lengths_of(input.units));
  input.material =
      read_material_without_L(material, input.L, "states, where L comes from [states]");
  if (input.start == StatesStart::scan)
    absent.material = origin_of(row_of(input, places_of(input).front().at)).physics->material;
  if (absent.material) take_material(file, material, *absent.material, input);
  if (input.rates > 0 && input.material.order == model::OrderDynamics::diffusive)
    states.fail("rates", "must be 0 with order = \"diffusive\": its rates are not known");
  if (file.has("follow")) input.follow = read_follow(follow, input);
  if (input.passes && input.follow && input.follow->most_negative == 0)
    follow.fail("most_negative",
                "must be >= 1 with passes = true: a branch of saddles would end at the first one");
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
       * (1 + input.eigenpairs / 20. + (input.rates > 0 ? 3 : 0)
          + (input.passes ? 12 : 0))  // two ways of 10 to 30 s for every other state
       * (input.follow ? 30 : 1);
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
  if (!input.symmetry.is_trivial()) toml.value("symmetry", input.symmetry.symbol());
  toml.value("eigenpairs", input.eigenpairs);
  toml.value("rates", input.rates);
  if (input.passes) toml.value("passes", input.passes);
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
