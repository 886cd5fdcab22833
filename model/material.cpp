#include "model/material.h"

#include <fmt/format.h>

#include <stdexcept>

namespace sbeh::model {

Material effective(const Material& material, Model model) {
  Material copy = material;
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
  copy.flexoelectric = flexoelectric.times(factor);
  copy.kappa_powers = kappa_powers.times(factor);
  copy.kappa_gauss_powers = kappa_gauss_powers.times(factor);
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
}  // namespace

void Material::validate() const {
  check_parameters(*this);
  require(l1() > 0, "6 L1 + L2 + L3", 4 * l1(), "> 0 (distortion energy)");
  require(splay() >= 0, "2 L1 + L2 + L3", splay() / 2.25, ">= 0 (bending energy)");
  // (κ/2)H² + κ_G K as a form in the principal curvatures: −2κ <= κ_G <= 0.
  require(2 * L1 + L3 >= 0, "2 L1 + L3", 2 * L1 + L3, ">= 0 (Gaussian energy)");
  require(2 * L1 + 2 * L2 + L3 >= 0, "2 L1 + 2 L2 + L3", 2 * L1 + 2 * L2 + L3,
          ">= 0 (Gaussian energy)");
  // Given ones are told by the order at which they fail.
  constexpr int samples = 1000;
  for (int k = 0; k <= samples && !kappa_powers.empty(); ++k)
    if (const double beta = double(k) / samples; kappa(beta) < 0)
      throw std::invalid_argument(
          fmt::format("kappa = {:.4g} at β = {}: must be >= 0 for 0 <= β <= 1", kappa(beta), beta));
  require(viscosity + friction_tangential > 0, "viscosity + friction_tangential",
          viscosity + friction_tangential, "> 0 (else nothing resists the flow)");
}

}  // namespace sbeh::model
