#include "model/material.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

namespace sbeh::model {

void AreaDifference::check_start(double total) const {
  constexpr double near = 1e-5;  // nothing next to the tolerance of a step
  if (is_there() && compliance() == 0 && std::abs(total - W2) > near)
    throw std::invalid_argument(fmt::format(
        "area_difference of infinite stiffness: the start has W2 = {:.10g}, which stays, "
        "not {}: say W2 = {:.10g}, or a finite stiffness",
        total, W2, total));
}

Material effective(const Material& material, Model model) {
  Material copy = has_free_order(model) ? material : material.with_uniform_order();
  if (!has_own_drag(model)) return copy;
  copy.viscosity = 0;
  copy.friction_normal = 1;
  copy.friction_tangential = area_constraint(model) == AreaConstraint::local ? 1 : 0;
  return copy;
}

Material Material::without_gaussian() const {
  Material copy = *this;
  copy.kappa_gauss_powers = Polynomial({0});
  return copy;
}

Material Material::with_given_scaled(double factor) const {
  Material copy = *this;
  copy.L2 *= factor;
  copy.L3 *= factor;
  copy.area_difference.stiffness *= factor;
  copy.flexoelectric = flexoelectric.times(factor);
  copy.kappa_powers = kappa_powers.times(factor);
  copy.kappa_gauss_powers = kappa_gauss_powers.times(factor);
  return copy;
}

Material Material::at_moment(double c) const {
  Material copy = *this;
  if (c != 0) copy.flexoelectric = flexoelectric.plus(c);
  return copy;
}

Material Material::with_uniform_order() const {
  Material copy = *this;
  copy.order = OrderDynamics::relaxing;
  copy.mean_order.reset();
  copy.order_mobility.reset();
  copy.lipid_density = Polynomial();  // full order has the area that it has
  return copy;
}

Material Material::at_chemical_potential(double mu) const {
  Material copy = *this;
  if (mu == 0) return copy;
  std::vector<double> u = potential.coefficients();
  u.resize(std::max(u.size(), std::size_t(2)), 0);
  u[0] += mu * mean_order.value_or(0);
  u[1] -= mu;
  copy.potential = Potential(u);
  return copy;
}

Material Material::with_L1(double L) const {
  Material copy = *this;
  copy.L1 = L;
  return copy;
}

Material Material::with_L(double L) const {
  Material copy = *this;
  copy.L1 = L;
  copy.L2 = copy.L3 = 0;
  return copy;
}

namespace {
void require(bool holds, const char* name, double value, const char* constraint) {
  if (!holds)
    throw std::invalid_argument(fmt::format("{} = {}: must be {}", name, value, constraint));
}
// Given ones are told by the order at which they fail.
void require_at_all_orders(const Polynomial& function, const auto& holds, const char* name,
                           const char* constraint) {
  constexpr int samples = 1000;
  for (int k = 0; k <= samples && !function.empty(); ++k) {
    const double beta = double(k) / samples, value = function.value(beta);
    if (!holds(value))
      throw std::invalid_argument(fmt::format("{} = {:.4g} at β = {}: must be {} for 0 <= β <= 1",
                                              name, value, beta, constraint));
  }
}
}  // namespace

void Material::validate() const {
  check_parameters(*this);
  require(area_difference.stiffness >= 0, "stiffness", area_difference.stiffness, ">= 0");
  require(std::isfinite(area_difference.W2), "W2", area_difference.W2, "finite");
  require(l1() > 0, "6 L1 + L2 + L3", 4 * l1(), "> 0 (distortion energy)");
  require(splay() >= 0, "2 L1 + L2 + L3", splay() / 2.25, ">= 0 (bending energy)");
  // (κ/2)H² + κ_G K as a form in the principal curvatures: −2κ <= κ_G <= 0.
  require(2 * L1 + L3 >= 0, "2 L1 + L3", 2 * L1 + L3, ">= 0 (Gaussian energy)");
  require(2 * L1 + 2 * L2 + L3 >= 0, "2 L1 + 2 L2 + L3", 2 * L1 + 2 * L2 + L3,
          ">= 0 (Gaussian energy)");
  require_at_all_orders(
      kappa_powers, [](double kappa) { return kappa >= 0; }, "kappa", ">= 0");
  require_at_all_orders(
      lipid_density, [](double n) { return n > 0; }, "lipid_density", "> 0");
  if (has_lipid_density() && (area_difference.is_there() || conserves_order()))
    throw std::invalid_argument(
        fmt::format("lipid_density with {}: not together, there is no area that both keep",
                    conserves_order() ? "a conserved order" : "area_difference"));
  if (conserves_order() && !mean_order)
    throw std::invalid_argument(
        fmt::format("order = \"{}\": needs mean_order, the (1/A)∫β dS that stays", name(order)));
  if (mean_order && !conserves_order())
    throw std::invalid_argument(fmt::format(
        "mean_order = {}: has a meaning with order = \"conserved\" or \"diffusive\" only",
        *mean_order));
  if (order_mobility && order != OrderDynamics::diffusive)
    throw std::invalid_argument(fmt::format(
        "order_mobility = {}: has a meaning with order = \"diffusive\" only", *order_mobility));
  require(viscosity + friction_tangential > 0, "viscosity + friction_tangential",
          viscosity + friction_tangential, "> 0 (else nothing resists the flow)");
}

}  // namespace sbeh::model
