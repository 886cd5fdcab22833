#include "studies/compare/compare_input.h"

#include "meshing/resolution.h"
#include "studies/io/description.h"
#include "studies/io/input_path.h"
#include "studies/parameters/input_kind.h"
#include "studies/parameters/material_input.h"
#include "studies/witnesses/evolution.h"
#include "studies/witnesses/state.h"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>

namespace sbeh::studies {

namespace fs = std::filesystem;

namespace {

const ParameterNames relax_keys{"tolerance", "rest_speed"};
constexpr double least_harmonic_volume = 0.65;

// The surface must be near enough to an ellipsoid.
void require_harmonic_shape(const TomlTable& table, const CompareInput& input) {
  if (!input.has(Witness::harmonics)) return;
  if (input.state.model != model::Model::SSH)
    table.fail("methods",
               "must not contain \"harmonics\" for model = \"SBEH\": it has full order only");
  if (input.state.branch == axisym::Branch::stomatocyte
      || input.state.reduced_volume < least_harmonic_volume)
    table.fail("methods",
               fmt::format("must not contain \"harmonics\" but for oblates and prolates with "
                           "reduced_volume >= {}",
                           least_harmonic_volume));
}

void read_case(const TomlTable& table, CompareInput& input) {
  axisym::StationaryCase& state = input.state;
  state.model = table.choice("model", rest_models);
  state.branch = table.choice("branch", axisym::classical_branches, std::optional(state.branch));
  state.reduced_volume = table.number("reduced_volume", reduced_volumes);
  if (state.reduced_volume == 1)
    table.fail("reduced_volume", "must be < 1: there is only the sphere, and nothing to compare");
  state.material.L1 = table.number("L", above(0));
  input.methods = table.choices("methods", values_of(Witness{}));
  if (input.methods.size() < 2)
    table.fail("methods", "must be two at least, to be compared with each other");
  table.refuse_word("methods", name(Witness::harmonic_flow),
                    "belongs to the evolution of a run: evolution = \"FILE\"");
  if (input.has(Witness::shooting) && state.model != model::Model::SSH)
    table.fail("methods",
               "must not contain \"shooting\" for model = \"SBEH\": it has full order only");
  if (input.has(Witness::flow) && state.branch == axisym::Branch::stomatocyte)
    table.fail("methods",
               "must not contain \"flow\" for branch = \"stomatocyte\": an ellipsoid does "
               "not go there");
  require_harmonic_shape(table, input);
  table.reject_unknown_keys();
}

HarmonicMethod read_harmonic_method(const TomlTable& table) {
  HarmonicMethod method;
  method.degree = table.integer("degree", 8, 24, method.degree);
  table.reject_unknown_keys();
  return method;
}

SurfaceMethod read_surface_method(const TomlTable& table, const CompareInput& input) {
  SurfaceMethod method;
  if (table.has("run")) {
    for (const char* key : {"start", "triangles", "end", "tolerance", "rest_speed"})
      table.refuse(key, "must not be given together with run, which has it");
    if (input.has(Witness::states))
      table.fail("run",
                 "must not be given where \"states\" is among the methods, which needs triangles");
    method.run = table.path("run");
  }
  method.revolved = table.word("start", {"ellipsoid", "revolved"}, "ellipsoid") == "revolved";
  if (input.has(Witness::surface3d) && input.state.branch == axisym::Branch::stomatocyte
      && method.run.empty() && !method.revolved)
    table.fail("start",
               "must be \"revolved\" for branch = \"stomatocyte\": an ellipsoid does not go "
               "there");
  method.triangles = table.integer("triangles", meshing::fewest_triangles, meshing::most_triangles,
                                   method.triangles);
  method.end_time = table.number("end", above(0), method.end_time);
  read_some(table, method.numerics, relax_keys);
  check(table, method.numerics);
  return method;
}

Tolerances read_tolerances(const TomlTable& table) {
  Tolerances tolerances;
  for (const std::string& quantity : tolerated_quantities())
    if (table.has(quantity)) tolerances[quantity] = table.number(quantity, above(0));
  table.reject_unknown_keys();
  return tolerances;
}

// Only flow and surface3d have histories, and from a revolved state there is none to tell of.
void require_histories(const TomlTable& tolerance_3d, const CompareInput& input) {
  if (!input.tolerance_3d.contains("history")) return;
  if (!input.has(Witness::flow) || !input.has(Witness::surface3d) || input.surface3d.revolved)
    tolerance_3d.fail("history",
                      "needs the methods \"flow\" and \"surface3d\", both from an ellipsoid");
}

// With a spontaneous curvature, or one by f, the shapes of these are others.
void refuse_spontaneous_curvature(const TomlTable& material, const CompareInput& input) {
  const model::Material& m = input.state.material;
  if (input.state.model != model::Model::SSH) return;
  for (const Witness witness : {Witness::shooting, Witness::harmonics}) {
    if (!input.has(witness)) continue;
    const std::string reason =
        fmt::format("must be 0 for the method \"{}\" of model = \"SSH\"", name(witness));
    if (m.spontaneous_curvature != 0) material.fail("spontaneous_curvature", reason);
    if (!m.flexoelectric.vanishes()) material.fail("flexoelectric", reason);
  }
}

// What newton and minimiser know and no other method.
void refuse_known_to_two(const TomlTable& material, const CompareInput& input) {
  for (const Witness witness : input.methods)
    if (witness != Witness::newton && witness != Witness::minimiser)
      for (const char* key : {"area_difference", "lipid_density"})
        material.refuse(key, fmt::format("must not be given for the method \"{}\": newton and "
                                         "minimiser alone know it",
                                         name(witness)));
}

void write_surface_method(TomlText& toml, const SurfaceMethod& method) {
  toml.table("surface3d");
  if (!method.run.empty()) {
    toml.value("run", method.run);
    return;
  }
  toml.value("start", std::string(method.revolved ? "revolved" : "ellipsoid"));
  toml.value("triangles", method.triangles);
  toml.value("end", method.end_time);
  write_some(toml, method.numerics, relax_keys);
}

void write_tolerances(TomlText& toml, const char* table, const Tolerances& tolerances) {
  if (tolerances.empty()) return;
  toml.table(table);
  for (const std::string& quantity : tolerated_quantities())
    if (const auto at = tolerances.find(quantity); at != tolerances.end())
      toml.value(quantity.c_str(), at->second);
}

}  // namespace

std::vector<std::string> tolerated_quantities() {
  std::vector<std::string> names;
  for (const Quantity& quantity : quantities()) names.emplace_back(quantity.name);
  names.emplace_back("distance");
  names.emplace_back("history");
  return names;
}

bool CompareInput::has(Witness witness) const {
  return std::find(methods.begin(), methods.end(), witness) != methods.end();
}

namespace {

// The run that the input holds itself, and where that is an input or a folder besides, what it is there.
EvolutionCase read_evolution_case(const TomlTable& file, const TomlTable& table) {
  std::optional<RunInput> held;
  if (file.has("evolution")) held = run_in(file.table("evolution"));
  if (held && !table.has("evolution")) return {.file = {}, .run = *held};
  EvolutionCase evolution{.file = table.path("evolution"), .run = {}};
  require_there(evolution.file);
  const fs::path description =
      evolution.has_ended() ? fs::path(evolution.file) / "run.toml" : fs::path(evolution.file);
  if (kind_of(description) != InputKind::run)
    table.fail("evolution", "must be an input of sbeh run, or the folder of such a run");
  evolution.run = read_run(description);
  if (!held) return evolution;
  if (const auto changes = differences(describe(*held, ""), describe(evolution.run, ""), {});
      !changes.empty())
    table.fail("evolution", "is not what [evolution] says (there and here): " + text_of(changes));
  return evolution;
}

// What the run says itself has no place beside it.
CompareInput read_evolution(const TomlTable& file, const TomlTable& table) {
  for (const char* key : {"material", "numerics", "surface3d", "harmonics", "tolerance", "units"})
    file.refuse(key, "has no place where evolution names a run");
  for (const char* key : {"model", "branch", "reduced_volume", "L"})
    table.refuse(key, "has no place where evolution names a run, which has it");
  CompareInput input;
  input.evolution = read_evolution_case(file, table);
  const RunInput& run = input.evolution->run;
  input.state.model = run.model;
  input.state.material = run.material;
  input.units = run.units;
  input.methods = table.choices("methods", values_of(Witness{}));
  for (const Witness method : input.methods)
    if (!follows_evolutions(method))
      table.refuse_word(
          "methods", name(method),
          "belongs to stationary states; of an evolution there are surface3d and harmonic_flow");
  if (input.methods.size() < 2)
    table.fail("methods", "must be two, to be compared with each other");
  if (const std::string reason = no_harmonic_flow(run); !reason.empty())
    table.refuse_word("methods", name(Witness::harmonic_flow), "has no place here: " + reason);
  table.reject_unknown_keys();
  const TomlTable harmonics = file.table("harmonic_flow"),
                  tolerance_3d = file.table("tolerance_3d");
  file.reject_unknown_keys();
  input.harmonic_flow.degree = harmonics.integer("degree", 6, 24, input.harmonic_flow.degree);
  input.harmonic_flow.tolerance =
      harmonics.number("tolerance", between(1e-12, 1e-3), input.harmonic_flow.tolerance);
  harmonics.reject_unknown_keys();
  input.tolerance_3d = read_tolerances(tolerance_3d);
  return input;
}

// The tables and keys of a whole input as those within a table of another one.
std::string within(const std::string& table, const std::string& description) {
  std::istringstream text(description);
  std::string all = fmt::format("\n[{}]\n", table);
  for (std::string line; std::getline(text, line);)
    if (line.starts_with('['))
      all += fmt::format("[{}.{}\n", table, line.substr(1));
    else if (!line.starts_with('#'))
      all += line + "\n";
  return all;
}

// The folder of a run that has ended is named, since it has the run's results too.
std::string describe_evolution(const CompareInput& input, std::string_view version) {
  TomlText toml(version);
  toml.table("compare");
  if (input.evolution->has_ended()) toml.value("evolution", input.evolution->file);
  toml.value("methods", input.methods);
  toml.table("harmonic_flow");
  toml.value("degree", input.harmonic_flow.degree);
  toml.value("tolerance", input.harmonic_flow.tolerance);
  write_tolerances(toml, "tolerance_3d", input.tolerance_3d);
  return toml.text() + within("evolution", describe(input.evolution->run, version));
}

}  // namespace

bool EvolutionCase::has_ended() const { return fs::is_directory(file); }

CompareInput read_compare(const fs::path& path) {
  const TomlTable file = TomlFile::parse(path);
  const TomlTable cases = file.table("compare");
  if (cases.has("evolution") || file.has("evolution")) return read_evolution(file, cases);
  if (file.has("harmonic_flow")) cases.refuse_misspelt({"evolution"});
  const TomlTable material = file.table("material"), numerics = file.table("numerics");
  const TomlTable surface = file.table("surface3d"), harmonics = file.table("harmonics"),
                  tolerance_3d = file.table("tolerance_3d"), tolerance = file.table("tolerance");
  file.has("units");
  file.refuse("harmonic_flow",
              "belongs to the evolution of a run, which evolution would name in [compare]");
  file.reject_unknown_keys();
  CompareInput input;
  input.units = read_units(file);
  read_case(cases, input);
  const bool on_triangles = input.has(Witness::surface3d) || input.has(Witness::states),
             by_harmonics = input.has(Witness::harmonics);
  if (!on_triangles)
    file.refuse("surface3d", "has no place without \"surface3d\" or \"states\" among the methods");
  if (!by_harmonics)
    file.refuse("harmonics", "has no place without \"harmonics\" among the methods");
  if (!on_triangles && !by_harmonics)
    file.refuse(
        "tolerance_3d",
        "has no place without \"surface3d\", \"states\" or \"harmonics\" among the methods");
  material.measured_by(lengths_of(input.units));
  refuse_known_to_two(material, input);
  input.state.material = read_material_without_L(material, {input.state.L()},
                                                 "a comparison, where L comes from [compare]")
                             .with_L1(input.state.L());
  if (input.state.material.conserves_order())
    material.fail("order", "must be \"relaxing\" in a comparison: most methods know no other");
  refuse_spontaneous_curvature(material, input);
  input.state.numerics = read_numerics<axisym::Numerics>(numerics);
  input.surface3d = read_surface_method(surface, input);
  input.harmonics = read_harmonic_method(harmonics);
  tolerance.refuse("history", "has its place in [tolerance_3d]: flow is compared with surface3d");
  input.tolerance = read_tolerances(tolerance);
  input.tolerance_3d = read_tolerances(tolerance_3d);
  require_histories(tolerance_3d, input);
  return input;
}

std::string describe(const CompareInput& input, std::string_view version) {
  if (input.evolution) return describe_evolution(input, version);
  TomlText toml(version);
  toml.table("compare");
  toml.value("model", input.state.model);
  toml.value("branch", input.state.branch);
  toml.value("reduced_volume", input.state.reduced_volume);
  toml.value("L", input.state.L());
  toml.value("methods", input.methods);
  write_material_without_L(toml, input.state.material);
  write_numerics(toml, input.state.numerics);
  if (input.has(Witness::surface3d) || input.has(Witness::states))
    write_surface_method(toml, input.surface3d);
  if (input.has(Witness::harmonics)) {
    toml.table("harmonics");
    toml.value("degree", input.harmonics.degree);
  }
  write_tolerances(toml, "tolerance", input.tolerance);
  write_tolerances(toml, "tolerance_3d", input.tolerance_3d);
  write_units(toml, input.units);
  return toml.text();
}

}  // namespace sbeh::studies
