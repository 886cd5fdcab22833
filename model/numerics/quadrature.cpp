#include "model/numerics/quadrature.h"

#include <boost/math/special_functions/legendre.hpp>

#include <array>
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

TriangleRule symmetric_triangle_rule() {
  // Points with the barycentric coordinates a, b, 1 − a − b in all different orders; the weights of all points sum to 1.
  struct Orbit {
    double weight, a, b;
    int orders;
  };
  constexpr double third = 1. / 3;
  constexpr std::array<Orbit, 6> orbits{{
      {0.0908179903827535801, third, third, 1},
      {0.0367259577564667047, 0.485577633383657377, 0.485577633383657377, 3},
      {0.0453210594355279348, 0.109481575485037055, 0.109481575485037055, 3},
      {0.0727579168454201086, 0.141707219414879955, 0.307939838764120950, 6},
      {0.0283272425310574848, 0.0250035347626863861, 0.246672560639902694, 6},
      {0.00942166696373282346, 0.00954081540029945758, 0.0668032510122002658, 6},
  }};
  TriangleRule rule{Eigen::Matrix2Xd(2, 25), Eigen::VectorXd(25)};
  Eigen::Index k = 0;
  for (const auto& [weight, a, b, orders] : orbits) {
    const double c = 1 - a - b;
    const std::array<Eigen::Vector2d, 6> images{{{a, b}, {b, c}, {c, a}, {b, a}, {c, b}, {a, c}}};
    for (int i = 0; i < orders; ++i, ++k) {
      rule.points.col(k) = images[std::size_t(i)];
      rule.weights[k] = weight / 2;
    }
  }
  return rule;
}

}  // namespace sbeh::model
