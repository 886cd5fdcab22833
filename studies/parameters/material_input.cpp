#include "studies/parameters/material_input.h"

#include "studies/io/spelling.h"

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

bool bounded_below(const std::vector<double>& coefficients) {
  std::size_t degree = coefficients.size();
  while (degree > 0 && coefficients[degree - 1] == 0) --degree;  // one more than the power
  return degree <= 1 || (degree % 2 == 1 && coefficients[degree - 1] > 0);
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

// All but the elastic constants.
model::Material read_rest(const TomlTable& table, model::Material material) {
  read_friction(table, material);
  read_parameters(table, material, elastic_constants);
  if (!material.kappa_powers.empty())
    refuse(table, {"residual_stiffness"},
           "must not be given together with kappa, which says all of the bending stiffness");
  check(table, material);
  return material;
}

}  // namespace

void read_value(const TomlTable& table, const char* powers, model::Potential& potential) {
  if (table.has(powers))
    table.refuse(potential_shorthand, "must not be given together with potential");
  for (const char* key : {powers, potential_shorthand}) {
    if (!table.has(key)) continue;
    potential = potential_of(table, key, key == powers);
    if (!bounded_below(potential.coefficients()))
      table.fail(key, "must be bounded below: its highest power even, with a coefficient > 0");
  }
}

void read_value(const TomlTable& table, const char* key, model::Polynomial& polynomial) {
  if (table.has(key)) polynomial = model::Polynomial(table.numbers(key));
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
    bool said = table.has(key);
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
  return read_rest(table, absent);
}

model::Material read_material_without_L(const TomlTable& table, std::string_view where) {
  refuse(table, {"L", "L1", "L2", "L3"}, "must not be given in " + std::string(where));
  return read_rest(table, {});
}

void write_material(TomlText& toml, const model::Material& material, model::Model model) {
  toml.table("material");
  write_parameters(toml, material, has_own_drag(model) ? parameters_of_drag : ParameterNames{});
}

void write_material_without_L(TomlText& toml, const model::Material& material) {
  toml.table("material");
  write_parameters(toml, material, elastic_constants);
}

void refuse_order(const TomlTable& table, model::Model model, const ParameterNames& keys) {
  if (has_free_order(model)) return;
  refuse(table, keys,
         "must not be given for model = " + in_quotes(name(model))
             + ", where the order is 2/3 everywhere");
}

}  // namespace sbeh::studies
