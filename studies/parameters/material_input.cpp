#include "studies/parameters/material_input.h"

#include "studies/io/spelling.h"

#include <numbers>
#include <utility>

namespace sbeh::studies {

namespace {

const ParameterNames elastic_constants{"L1", "L2", "L3"};

constexpr const char* potential_shorthand = "landau_de_gennes";

void refuse(const TomlTable& table, const ParameterNames& keys, const std::string& reason) {
  for (const std::string_view key : keys) table.refuse(key, reason);
}

// L, which stands for all elastic constants.
void read_L(const TomlTable& table, model::Material& material) {
  if (!table.has("L")) return;
  refuse(table, elastic_constants,
         "must not be given together with L, which means L1 = L, L2 = L3 = 0");
  material = material.with_L(table.number("L", above(0)));
}

// friction, which stands for both.
void read_friction(const TomlTable& table, model::Material& material) {
  if (!table.has("friction")) return;
  refuse(table, {"friction_tangential", "friction_normal"},
         "must not be given together with friction, which sets both");
  material.friction_tangential = material.friction_normal = table.number("friction", at_least(0));
}

// The potential that `key` describes, its powers or what stands for them.
model::Potential potential_of(const TomlTable& table, const char* key, bool powers) {
  try {
    if (powers) return model::Potential(table.numbers(key));
    const TomlTable abc = table.table(key);
    const double a = abc.number("a"), b = abc.number("b"), c = abc.number("c");
    abc.reject_unknown_keys();
    return model::Potential::landau_de_gennes(a, b, c);
  } catch (const std::invalid_argument&) {
    table.fail(key, "coefficients must be smaller");
  }
}

// All but the elastic constants, unchecked.
model::Material read_functions(const TomlTable& table, model::Material material) {
  read_friction(table, material);
  read_parameters(table, material, elastic_constants);
  if (!material.kappa_powers.empty())
    refuse(table, {"residual_stiffness"},
           "must not be given together with kappa, which says all of the bending stiffness");
  // What a result was computed with may say more of another order.
  if (!material.conserves_order() && !table.has("mean_order")) material.mean_order.reset();
  if (material.order != model::OrderDynamics::diffusive && !table.has("order_mobility"))
    material.order_mobility.reset();
  return material;
}

// A given κ(β) says all of the stiffness.
ParameterNames without_k0(const model::Material& material, ParameterNames without) {
  if (!material.kappa_powers.empty()) without.emplace_back("residual_stiffness");
  return without;
}

}  // namespace

bool is_bounded_below(const model::Potential& potential) {
  const std::vector<double>& coefficients = potential.coefficients();
  std::size_t degree = coefficients.size();
  while (degree > 0 && coefficients[degree - 1] == 0) --degree;  // one more than the power
  return degree <= 1 || (degree % 2 == 1 && coefficients[degree - 1] > 0);
}

void read_value(const TomlTable& table, const char* powers, model::Potential& potential) {
  if (table.has(powers))
    table.refuse(potential_shorthand, "must not be given together with potential");
  for (const char* key : {powers, potential_shorthand}) {
    if (!table.has(key)) continue;
    potential = potential_of(table, key, key == powers);
    if (!is_bounded_below(potential))
      table.fail(key, "must be bounded below: its highest power even, with a coefficient > 0");
  }
}

void read_value(const TomlTable& table, const char* key, model::Polynomial& polynomial) {
  if (table.has(key)) polynomial = model::Polynomial(table.numbers(key));
}

void read_value(const TomlTable& table, const char* key, model::AreaDifference& of) {
  if (!table.has(key)) return;
  const TomlTable given = table.table(key);
  of.stiffness = given.number_or_infinity("stiffness", above(0));
  const bool by_areas = given.has("delta_a0");
  given.refuse_misspelt({"delta_a0"});
  if (by_areas) given.refuse("W2", "must not be given together with delta_a0, which is −W2/8π");
  of.W2 = by_areas ? -8 * std::numbers::pi * given.number("delta_a0") : given.number("W2");
  given.reject_unknown_keys();
}

bool is_complete(const TomlTable& table, model::Model model) {
  bool complete = table.has("L"), all = true;
  for (const std::string_view key : elastic_constants) all = table.has(key) && all;
  complete = complete || all;
  const bool friction = table.has("friction");
  const model::Material any;
  for_each_parameter(any, [&](const model::Parameter& parameter, const auto&) {
    const std::string_view key = parameter.name;
    if (contains(elastic_constants, key)) return;
    if (key == "kappa" || key == "kappa_gauss") return;  // as the elastic constants say
    if (key == "area_difference" || key == "lipid_density" || key == "order" || key == "mean_order"
        || key == "order_mobility")
      return;  // none, relaxing
    bool said = table.has(key);
    if (key == "residual_stiffness") said = table.has("kappa") || said;
    if (key == "potential") said = table.has(potential_shorthand) || said;
    if (contains(parameters_of_drag, key))
      said = said || has_own_drag(model) || (friction && key != "viscosity");
    complete = complete && said;
  });
  return complete;
}

model::Material read_material(const TomlTable& table, model::Model model, model::Material absent) {
  if (has_own_drag(model)) {
    const model::Material defaults;
    absent.viscosity = defaults.viscosity;
    absent.friction_tangential = defaults.friction_tangential;
    absent.friction_normal = defaults.friction_normal;
    refuse(table, {"viscosity", "friction", "friction_tangential", "friction_normal"},
           "must not be given for model = " + in_quotes(name(model))
               + ", which has no viscosity and friction 1");
  }
  read_L(table, absent);
  read_some(table, absent, elastic_constants);
  model::Material material = read_functions(table, absent);
  check(table, material);
  return material;
}

model::Material read_material_without_L(const TomlTable& table, const std::vector<double>& L,
                                        std::string_view where) {
  refuse(table, {"L", "L1"}, "must not be given in " + std::string(where));
  model::Material material;
  read_some(table, material, {"L2", "L3"});
  material = read_functions(table, material);
  for (const double one : {L.front(), L.back()}) check(table, material.with_L1(one));
  return material;
}

void write_material(TomlText& toml, const model::Material& material, model::Model model) {
  toml.table("material");
  write_parameters(
      toml, material,
      without_k0(material, has_own_drag(model) ? parameters_of_drag : ParameterNames{}));
}

void write_material_without_L(TomlText& toml, const model::Material& material,
                              ParameterNames without) {
  toml.table("material");
  without.emplace_back("L1");
  write_parameters(toml, material, without_k0(material, std::move(without)));
}

void refuse_order(const TomlTable& table, model::Model model, const ParameterNames& keys) {
  if (has_free_order(model)) return;
  refuse(table, keys,
         "must not be given for model = " + in_quotes(name(model))
             + ", where the order is 2/3 everywhere");
}

}  // namespace sbeh::studies
