#include "model/potential.h"

#include <cmath>
#include <stdexcept>
#include <string>

namespace sbeh::model {

Potential Potential::landau_de_gennes(double a, double b, double c) {
  return Potential({0, 0, 1.5 * a, 0.5 * b, 1.125 * c});
}

Potential::Potential(std::vector<double> coefficients) : coefficients_(std::move(coefficients)) {
  for (std::size_t k = 0; k < coefficients_.size(); ++k)
    if (!std::isfinite(coefficients_[k]))
      throw std::invalid_argument("potential: coefficient " + std::to_string(k) + " is not finite");
}

}  // namespace sbeh::model
