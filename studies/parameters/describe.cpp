#include "studies/parameters/describe.h"

#include "studies/io/toml_reader.h"
#include "studies/io/toml_text.h"

#include <fmt/format.h>

namespace sbeh::studies {

namespace {

enum class Elasticity { with_L, without_L };

/// Without what the model says itself. The binding names every member, so that a new one is not
/// forgotten here.
void write_material(TomlText& toml, const model::Material& material, Elasticity elasticity,
                    model::Model model = model::Model::SBEH) {
  const auto& [L1, L2, L3, potential, viscosity, immobility, friction_tangential, friction_normal,
               order_viscosity, residual_stiffness, spontaneous_curvature] = material;
  toml.table("material");
  if (elasticity == Elasticity::with_L) {
    toml.value("L1", L1);
    toml.value("L2", L2);
    toml.value("L3", L3);
  }
  toml.value("potential", potential.coefficients());
  if (!has_own_drag(model)) toml.value("viscosity", viscosity);
  toml.value("immobility", immobility);
  if (!has_own_drag(model)) {
    toml.value("friction_tangential", friction_tangential);
    toml.value("friction_normal", friction_normal);
  }
  toml.value("order_viscosity", order_viscosity);
  toml.value("residual_stiffness", residual_stiffness);
  toml.value("spontaneous_curvature", spontaneous_curvature);
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
  toml.value("tolerance", method.numerics.tolerance);
  toml.value("rest_speed", method.numerics.rest_speed);
}

void write_tolerances(TomlText& toml, const char* table, const Tolerances& tolerances) {
  if (tolerances.empty()) return;
  toml.table(table);
  for (const std::string& quantity : tolerated_quantities())
    if (const auto at = tolerances.find(quantity); at != tolerances.end())
      toml.value(quantity.c_str(), at->second);
}

void write_time_control(TomlText& toml, const model::TimeControl& control) {
  const auto& [tolerance, first_step, smallest_step, largest_step, extrapolate, rest_speed] =
      control;
  toml.value("tolerance", tolerance);
  toml.value("first_step", first_step);
  toml.value("smallest_step", smallest_step);
  toml.value("largest_step", largest_step);
  toml.value("extrapolate", extrapolate);
  toml.value("rest_speed", rest_speed);
}

void write_numerics(TomlText& toml, const axisym::Numerics& numerics) {
  toml.table("numerics");
  toml.value("elements", numerics.elements);
  toml.value("grading", numerics.grading);
  write_time_control(toml, numerics);
}

}  // namespace

InputKind kind_of(const std::filesystem::path& path) {
  const TomlTable file = TomlFile::parse(path);
  const bool scan = file.has("scan"), relax = file.has("start"), run = file.has("surface"),
             compare = file.has("compare"), stability = file.has("stability");
  const int count = scan + relax + run + compare + stability;
  if (count != 1)
    throw InputError(fmt::format(
        "{}: must have {}[scan] (a scan), [start] (one axisymmetric evolution), [surface] (one "
        "3D run), [compare] (one case by several methods) or [stability] (axisymmetric states, "
        "perturbed in 3D){}",
        path.string(), count > 1 ? "only one of " : "a table ",
        count > 1 ? "" : "; it has none of them"));
  return scan    ? InputKind::scan
       : relax   ? InputKind::relax
       : run     ? InputKind::run
       : compare ? InputKind::compare
                 : InputKind::stability;
}

std::string describe(const ScanInput& input, std::string_view version) {
  TomlText toml(version);
  toml.table("scan");
  toml.value("reduced_volume", input.reduced_volume);
  toml.value("L", input.L);
  toml.value("models", input.models);
  toml.value("branches", input.branches);
  toml.value("method", input.method);
  if (input.method == Method::flow) toml.value("end_time", input.flow_end_time);
  if (input.method == Method::newton) toml.value("beyond_fold", input.beyond_fold);
  write_material(toml, input.material, Elasticity::without_L);
  write_numerics(toml, input.numerics);
  return toml.text();
}

std::string describe(const RelaxInput& input, std::string_view version) {
  TomlText toml(version);
  toml.value("model", input.model);
  write_start(toml, input);
  write_material(toml, input.material, Elasticity::with_L, input.model);
  write_numerics(toml, input.numerics);
  write_times(toml, input.times, "profiles");
  return toml.text();
}

std::string describe(const RunInput& input, std::string_view version) {
  TomlText toml(version);
  toml.value("model", input.model);
  write_surface(toml, input);
  write_material(toml, input.material, Elasticity::with_L, input.model);
  toml.table("numerics");
  write_time_control(toml, input.numerics);
  toml.value("integrator", std::string(name(input.numerics.integrator)));
  toml.value("scheme", std::string(name(input.numerics.scheme)));
  toml.value("factorisation", std::string(name(input.numerics.factorisation)));
  toml.value("solver_tolerance", input.numerics.solver_tolerance);
  toml.value("remesh", input.numerics.remesh);
  toml.value("most_triangles", input.numerics.most_triangles);
  write_times(toml, input.times, "frames");
  toml.value("checkpoint_minutes", input.checkpoint_minutes);
  return toml.text();
}

std::string describe(const CompareInput& input, std::string_view version) {
  TomlText toml(version);
  toml.table("compare");
  toml.value("model", input.model);
  toml.value("branch", input.branch);
  toml.value("reduced_volume", input.reduced_volume);
  toml.value("L", input.L);
  toml.value("methods", input.methods);
  write_material(toml, input.material, Elasticity::without_L);
  write_numerics(toml, input.numerics);
  if (input.has(Witness::surface3d)) write_surface_method(toml, input.surface3d);
  if (input.has(Witness::harmonics)) {
    toml.table("harmonics");
    toml.value("degree", input.harmonics.degree);
  }
  write_tolerances(toml, "tolerance", input.tolerance);
  write_tolerances(toml, "tolerance_3d", input.tolerance_3d);
  return toml.text();
}

std::string describe(const StabilityInput& input, std::string_view version) {
  TomlText toml(version);
  toml.table("stability");
  toml.value("reduced_volume", input.reduced_volume);
  toml.value("L", input.L);
  toml.value("models", input.models);
  toml.value("branches", input.branches);
  toml.value("perturbations", input.perturbations);
  toml.table("surface3d");
  toml.value("triangles", input.triangles);
  toml.value("end", input.end_time);
  toml.value("largest_step", input.numerics_3d.largest_step);
  toml.value("tolerance", input.numerics_3d.tolerance);
  write_material(toml, input.material, Elasticity::without_L);
  write_numerics(toml, input.numerics);
  return toml.text();
}

}  // namespace sbeh::studies
