#include "model/numerics/quadrature.h"

#include <boost/math/special_functions/legendre.hpp>

#include <cmath>
#include <stdexcept>
#include <vector>

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

namespace {

// Points with the barycentric coordinates a, b, 1 − a − b in all orders: six; three where a = b, one where all are equal.
struct PointOrbit {
  double weight, a, b;  // the weights of all points sum to 1
};

std::vector<PointOrbit> orbits_of(int degree) {
  constexpr double third = 1. / 3;
  if (degree == 8)
    return {{0.144315607677787168, third, third},
            {0.0950916342672846248, 0.459292588292723156, 0.459292588292723156},
            {0.10321737053471825, 0.170569307751760207, 0.170569307751760207},
            {0.0324584976231980803, 0.0505472283170309755, 0.0505472283170309755},
            {0.0272303141744349943, 0.00839477740995760534, 0.263112829634638113}};
  if (degree == 10)
    return {{0.0908179903827535801, third, third},
            {0.0367259577564667047, 0.485577633383657377, 0.485577633383657377},
            {0.0453210594355279348, 0.109481575485037055, 0.109481575485037055},
            {0.0727579168454201086, 0.141707219414879955, 0.30793983876412095},
            {0.0283272425310574848, 0.0250035347626863861, 0.246672560639902694},
            {0.00942166696373282346, 0.00954081540029945758, 0.0668032510122002658}};
  if (degree == 12)
    return {{0.0257310664404553354, 0.488217389773804883, 0.488217389773804883},
            {0.0436925445380384021, 0.439724392294460273, 0.439724392294460273},
            {0.0628582242178851004, 0.271210385012115922, 0.271210385012115922},
            {0.034796112930708943, 0.127576145541585925, 0.127576145541585925},
            {0.00616626105155901723, 0.0213173504532103702, 0.0213173504532103702},
            {0.0403715577663809295, 0.115343494534697999, 0.275713269685514194},
            {0.0223567732023034457, 0.0228383322222570296, 0.281325580989939548},
            {0.0173162311086588924, 0.0257340505483302282, 0.116251915907597141}};
  throw std::invalid_argument("symmetric_triangle_rule: degree must be 8, 10 or 12");
}

}  // namespace

TriangleRule symmetric_triangle_rule(int degree) {
  std::vector<Eigen::Vector3d> points;  // and weights
  for (const auto& [weight, a, b] : orbits_of(degree)) {
    const double c = 1 - a - b;
    const bool all_equal = a == b && std::abs(a - c) < 1e-12;
    std::vector<Eigen::Vector2d> orbit{{a, b}};
    if (!all_equal) orbit.insert(orbit.end(), {{b, c}, {c, a}});
    if (a != b) orbit.insert(orbit.end(), {{b, a}, {c, b}, {a, c}});
    for (const Eigen::Vector2d& x : orbit) points.emplace_back(x[0], x[1], weight / 2);
  }
  TriangleRule rule{Eigen::Matrix2Xd(2, points.size()), Eigen::VectorXd(points.size())};
  for (int k = 0; k < rule.size(); ++k) {
    rule.points.col(k) = points[std::size_t(k)].head<2>();
    rule.weights[k] = points[std::size_t(k)][2];
  }
  return rule;
}

}  // namespace sbeh::model
