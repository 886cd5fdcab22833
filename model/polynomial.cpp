#include "model/polynomial.h"

#include "model/potential.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

namespace sbeh::model {

Polynomial::Polynomial(std::vector<double> coefficients) : coefficients_(std::move(coefficients)) {
  for (std::size_t k = 0; k < coefficients_.size(); ++k)
    if (!std::isfinite(coefficients_[k]))
      throw std::invalid_argument("coefficient " + std::to_string(k) + " is not finite");
}

bool Polynomial::vanishes() const {
  return std::ranges::all_of(coefficients_, [](double c) { return c == 0; });
}

Polynomial Polynomial::times(double factor) const {
  std::vector<double> c = coefficients_;
  for (double& one : c) one *= factor;
  return Polynomial(std::move(c));
}

Polynomial Polynomial::plus(double constant) const {
  std::vector<double> c = coefficients_;
  if (c.empty()) c.push_back(0);
  c[0] += constant;
  return Polynomial(std::move(c));
}

Potential Potential::landau_de_gennes(double a, double b, double c) {
  return Potential({0, 0, 1.5 * a, 0.5 * b, 1.125 * c});
}

}  // namespace sbeh::model
