#include "studies/parameters/physics_numbers.h"

#include "model/names.h"
#include "studies/parameters/parameters.h"

#include <fmt/format.h>

#include <algorithm>
#include <concepts>
#include <string_view>

namespace sbeh::studies {

namespace {

constexpr std::string_view parameter_prefix = "material.";

Eigen::VectorXd as_numbers(double value) { return Eigen::VectorXd::Constant(1, value); }
Eigen::VectorXd as_numbers(const model::Polynomial& polynomial) {
  const std::vector<double>& c = polynomial.coefficients();
  return Eigen::Map<const Eigen::VectorXd>(c.data(), Eigen::Index(c.size()));
}
Eigen::VectorXd as_numbers(const model::AreaDifference& of) {
  return Eigen::Vector2d(of.stiffness, of.W2);
}
void set(model::AreaDifference& of, const Eigen::VectorXd& numbers) {
  of = {numbers[0], numbers.size() > 1 ? numbers[1] : 0};
}
Eigen::VectorXd as_numbers(const std::optional<double>& value) { return as_numbers(*value); }
Eigen::VectorXd as_numbers(model::OrderDynamics value) { return as_numbers(double(int(value))); }
void set(double& value, const Eigen::VectorXd& numbers) { value = numbers[0]; }
void set(std::optional<double>& value, const Eigen::VectorXd& numbers) { value = numbers[0]; }
void set(model::OrderDynamics& value, const Eigen::VectorXd& numbers) {
  constexpr auto known = values_of(model::OrderDynamics{});
  const double place = numbers[0];
  if (place >= 0 && place < double(known.size())) value = known.at(std::size_t(place));
}
template <std::derived_from<model::Polynomial> Polynomial>
void set(Polynomial& polynomial, const Eigen::VectorXd& numbers) {
  polynomial = Polynomial({numbers.begin(), numbers.end()});
}

}  // namespace

void write_physics(const Physics& physics, std::map<std::string, Eigen::VectorXd>& numbers) {
  numbers["model"] = as_numbers(double(int(physics.model)));
  for_each_parameter(physics.material, [&](const model::Parameter& parameter, const auto& value) {
    if (is_said(value)) numbers[std::string(parameter_prefix) + parameter.name] = as_numbers(value);
  });
}

std::optional<Physics> physics_in(const std::map<std::string, Eigen::VectorXd>& numbers,
                                  const std::string& file) {
  const auto model = numbers.find("model");
  if (model == numbers.end()) return {};
  const auto fail = [&](const std::string& what) {
    throw InputError(fmt::format("{}: its {} is not known to this version of sbeh", file, what));
  };
  constexpr auto models = values_of(model::Model{});
  const double place = model->second[0];
  if (!(place >= 0 && place < double(models.size()))) fail("model");
  Physics physics{.model = models.at(std::size_t(place)), .material = {}};
  std::size_t known = 0;
  for_each_parameter(physics.material, [&](const model::Parameter& parameter, auto& value) {
    const auto at = numbers.find(std::string(parameter_prefix) + parameter.name);
    if (at == numbers.end() || at->second.size() == 0) return;
    set(value, at->second);
    ++known;
  });
  const auto parameters = std::ranges::count_if(
      numbers, [](const auto& one) { return one.first.starts_with(parameter_prefix); });
  if (std::size_t(parameters) != known) fail("material");
  return physics;
}

}  // namespace sbeh::studies
