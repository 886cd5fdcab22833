#include "model/numerics/quadrature.h"

#include <boost/math/special_functions/legendre.hpp>

#include <stdexcept>

namespace sbeh::model {

IntervalRule gauss_rule(int n) {
  if (n < 1) throw std::invalid_argument("gauss_rule: needs at least one point");
  // Boost gives the non-negative zeros of P_n in ascending order.
  const auto zeros = boost::math::legendre_p_zeros<double>(n);
  IntervalRule rule{Eigen::VectorXd(n), Eigen::VectorXd(n)};
  for (std::size_t k = 0; k < zeros.size(); ++k) {
    const double x = zeros[k], slope = boost::math::legendre_p_prime(n, x);
    const double weight = 1 / ((1 - x * x) * slope * slope);
    const Eigen::Index upper = n / 2 + Eigen::Index(k), lower = n - 1 - upper;
    rule.points[upper] = (1 + x) / 2;
    rule.points[lower] = (1 - x) / 2;
    rule.weights[upper] = rule.weights[lower] = weight;
  }
  return rule;
}

TriangleRule triangle_rule(int degree) {
  if (degree < 0) throw std::invalid_argument("triangle_rule: degree must be >= 0");
  const IntervalRule along = gauss_rule(degree / 2 + 1);
  const IntervalRule across = gauss_rule((degree + 1) / 2 + 1);  // one degree more: Jacobian 1 − x
  TriangleRule rule;
  rule.points.resize(2, along.size() * across.size());
  rule.weights.resize(along.size() * across.size());
  Eigen::Index k = 0;
  for (int i = 0; i < across.size(); ++i)
    for (int j = 0; j < along.size(); ++j, ++k) {
      const double x = across.points[i];
      rule.points.col(k) << x, (1 - x) * along.points[j];
      rule.weights[k] = across.weights[i] * (1 - x) * along.weights[j];
    }
  return rule;
}

}  // namespace sbeh::model
