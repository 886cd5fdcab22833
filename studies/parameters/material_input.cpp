#include "studies/parameters/material_input.h"

#include "studies/io/spelling.h"

#include <algorithm>
#include <iterator>

namespace sbeh::studies {

namespace {

void read_elastic_constants(const TomlTable& table, model::Material& material) {
  if (table.has("L")) {
    for (const char* key : {"L1", "L2", "L3"})
      table.refuse(key, "must not be given together with L, which means L1 = L, L2 = L3 = 0");
    material = material.with_L(table.number("L", above(0)));
  }
  material.L1 = table.number("L1", {}, material.L1);
  material.L2 = table.number("L2", {}, material.L2);
  material.L3 = table.number("L3", {}, material.L3);
}

void read_friction(const TomlTable& table, model::Material& material) {
  if (table.has("friction")) {
    for (const char* key : {"friction_tangential", "friction_normal"})
      table.refuse(key, "must not be given together with friction, which sets both");
    material.friction_tangential = material.friction_normal = table.number("friction", at_least(0));
  }
  material.friction_tangential =
      table.number("friction_tangential", {}, material.friction_tangential);
  material.friction_normal = table.number("friction_normal", {}, material.friction_normal);
}

bool bounded_below(const std::vector<double>& coefficients) {
  std::size_t degree = coefficients.size();
  while (degree > 0 && coefficients[degree - 1] == 0) --degree;  // one more than the power
  return degree <= 1 || (degree % 2 == 1 && coefficients[degree - 1] > 0);
}

/// The potential that `key` describes.
model::Potential read_potential(const TomlTable& table, const std::string& key) {
  try {
    if (key == "potential") return model::Potential(table.numbers(key));
    const TomlTable abc = table.table(key);
    const double a = abc.number("a"), b = abc.number("b"), c = abc.number("c");
    abc.reject_unknown_keys();
    return model::Potential::landau_de_gennes(a, b, c);
  } catch (const std::invalid_argument&) {
    table.fail(key, "coefficients must be smaller");
  }
}

void read_potential(const TomlTable& table, model::Material& material) {
  if (table.has("potential"))
    table.refuse("landau_de_gennes", "must not be given together with potential");
  for (const char* key : {"potential", "landau_de_gennes"}) {
    if (!table.has(key)) continue;
    material.potential = read_potential(table, key);
    if (!bounded_below(material.potential.coefficients()))
      table.fail(key, "must be bounded below: its highest power even, with a coefficient > 0");
  }
}

/// All but the elastic constants. Ranges are those of Material::validate().
model::Material read_rest(const TomlTable& table, model::Material material) {
  material.viscosity = table.number("viscosity", {}, material.viscosity);
  material.immobility = table.number("immobility", {}, material.immobility);
  read_friction(table, material);
  material.order_viscosity = table.number("order_viscosity", {}, material.order_viscosity);
  material.residual_stiffness = table.number("residual_stiffness", {}, material.residual_stiffness);
  material.spontaneous_curvature =
      table.number("spontaneous_curvature", {}, material.spontaneous_curvature);
  read_potential(table, material);
  table.reject_unknown_keys();
  try {
    material.validate();
  } catch (const std::invalid_argument& error) {
    table.fail_from(error);
  }
  return material;
}

}  // namespace

model::Material read_material(const TomlTable& table, model::Model model, model::Material absent) {
  if (has_own_drag(model))
    for (const char* key : {"viscosity", "friction", "friction_tangential", "friction_normal"})
      table.refuse(key, "must not be given for model = " + in_quotes(name(model))
                            + ", which has no viscosity and friction 1");
  read_elastic_constants(table, absent);
  return read_rest(table, absent);
}

model::Material read_material_without_L(const TomlTable& table, std::string_view where) {
  for (const char* key : {"L", "L1", "L2", "L3"})
    table.refuse(key, "must not be given in " + std::string(where));
  return read_rest(table, {});
}

namespace {

void read_time_control(const TomlTable& table, model::TimeControl& control) {
  control.tolerance = table.number("tolerance", {}, control.tolerance);
  control.first_step = table.number("first_step", {}, control.first_step);
  control.smallest_step = table.number("smallest_step", {}, control.smallest_step);
  control.largest_step = table.number("largest_step", {}, control.largest_step);
  control.extrapolate = table.boolean("extrapolate", control.extrapolate);
  control.rest_speed = table.number("rest_speed", {}, control.rest_speed);
}

template <class Numerics>
Numerics checked(const TomlTable& table, const Numerics& numerics) {
  table.reject_unknown_keys();
  try {
    numerics.validate();
  } catch (const std::invalid_argument& error) {
    table.fail_from(error);
  }
  return numerics;
}

}  // namespace

axisym::Numerics read_numerics(const TomlTable& table) {
  constexpr int any = std::numeric_limits<int>::max();
  axisym::Numerics numerics;
  numerics.elements = table.integer("elements", -any, any, numerics.elements);
  numerics.grading = table.number("grading", {}, numerics.grading);
  read_time_control(table, numerics);
  return checked(table, numerics);
}

surface3d::Numerics read_numerics_3d(const TomlTable& table) {
  surface3d::Numerics numerics;
  read_time_control(table, numerics);
  const std::string split = name(surface3d::Scheme::split),
                    monolithic = name(surface3d::Scheme::monolithic);
  numerics.scheme = table.word("scheme", {split, monolithic}, name(numerics.scheme)) == split
                      ? surface3d::Scheme::split
                      : surface3d::Scheme::monolithic;
  const std::string two_step = name(surface3d::Integrator::two_step),
                    doubling = name(surface3d::Integrator::step_doubling);
  numerics.integrator =
      table.word("integrator", {two_step, doubling}, name(numerics.integrator)) == two_step
          ? surface3d::Integrator::two_step
          : surface3d::Integrator::step_doubling;
  const std::string lagged = name(surface3d::Factorisation::lagged),
                    every_step = name(surface3d::Factorisation::every_step);
  numerics.factorisation =
      table.word("factorisation", {lagged, every_step}, name(numerics.factorisation)) == lagged
          ? surface3d::Factorisation::lagged
          : surface3d::Factorisation::every_step;
  numerics.solver_tolerance = table.number("solver_tolerance", {}, numerics.solver_tolerance);
  if (numerics.integrator == surface3d::Integrator::two_step && !numerics.extrapolate)
    table.fail("extrapolate",
               "must be true with integrator = \"two-step\", which is of second order");
  numerics.remesh = table.boolean("remesh", numerics.remesh);
  constexpr int any = std::numeric_limits<int>::max();
  numerics.most_triangles = table.integer("most_triangles", -any, any, numerics.most_triangles);
  return checked(table, numerics);
}

namespace {

constexpr model::Model models[] = {model::Model::SBEH, model::Model::SSH,
                                   model::Model::HelfrichLocal, model::Model::HelfrichGlobal};

}  // namespace

const std::vector<std::string>& model_words() {
  static const std::vector<std::string> words = [] {
    std::vector<std::string> names;
    for (const model::Model model : models) names.emplace_back(name(model));
    return names;
  }();
  return words;
}

const std::vector<std::string>& scan_model_words() {
  static const std::vector<std::string> words{name(model::Model::SBEH), name(model::Model::SSH)};
  return words;
}

model::Model model_of(const std::string& word) {
  return *std::find_if(std::begin(models), std::end(models),
                       [&](model::Model model) { return word == name(model); });
}

void refuse_order(const TomlTable& table, model::Model model,
                  const std::vector<std::string>& keys) {
  if (has_free_order(model)) return;
  for (const std::string& key : keys)
    table.refuse(key, "must not be given for model = " + in_quotes(name(model))
                          + ", where the order is 2/3 everywhere");
}

}  // namespace sbeh::studies
