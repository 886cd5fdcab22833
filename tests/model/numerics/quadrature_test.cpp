// Quadrature against the closed integrals of monomials.
#include "model/numerics/quadrature.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace sbeh::model {
namespace {

// All integrals are at most 1 and are sums of positive terms; points and weights come from a Newton
// iteration and are accurate to a few last places.
constexpr double rounding = 50 * std::numeric_limits<double>::epsilon();

double factorial(int n) { return std::tgamma(n + 1); }

double integral_of_power(const IntervalRule& rule, int a) {
  double sum = 0;
  for (int i = 0; i < rule.size(); ++i) sum += rule.weights[i] * std::pow(rule.points[i], a);
  return sum;
}

double integral_of_monomial(const TriangleRule& rule, int a, int b) {
  double sum = 0;
  for (int i = 0; i < rule.size(); ++i)
    sum += rule.weights[i] * std::pow(rule.points(0, i), a) * std::pow(rule.points(1, i), b);
  return sum;
}

TEST(GaussRule, is_exact_up_to_degree_2n_minus_1) {
  for (int n = 1; n <= 20; ++n)
    for (int a = 0; a < 2 * n; ++a)
      EXPECT_NEAR(integral_of_power(gauss_rule(n), a), 1. / (a + 1), rounding)
          << n << " points, x^" << a;
}

TEST(GaussRule, misses_degree_2n_by_the_norm_of_the_Legendre_polynomial) {
  // The error in x^{2n} is ∫ p_n² dx, p_n monic on [0, 1]: (n!)⁴/((2n + 1)((2n)!)²).
  for (int n = 1; n <= 10; ++n) {
    const double norm = std::pow(factorial(n), 4) / ((2 * n + 1) * std::pow(factorial(2 * n), 2));
    EXPECT_NEAR(1. / (2 * n + 1) - integral_of_power(gauss_rule(n), 2 * n), norm, rounding) << n;
    EXPECT_GT(norm, 10 * rounding);
  }
}

TEST(GaussRule, has_positive_weights_and_ascending_points_symmetric_about_the_middle) {
  for (int n = 1; n <= 48; ++n) {
    const IntervalRule rule = gauss_rule(n);
    ASSERT_EQ(rule.size(), n);
    ASSERT_EQ(rule.weights.size(), n);
    EXPECT_NEAR(rule.weights.sum(), 1, rounding);
    for (int i = 0; i < n; ++i) {
      EXPECT_GT(rule.weights[i], 0);
      EXPECT_GT(rule.points[i], i == 0 ? 0 : rule.points[i - 1]);
      EXPECT_LT(rule.points[i], 1);
      EXPECT_NEAR(rule.points[i] + rule.points[n - 1 - i], 1, rounding);
      EXPECT_EQ(rule.weights[i], rule.weights[n - 1 - i]);
    }
  }
}

TEST(TriangleRule, is_exact_up_to_its_degree) {
  for (int degree = 0; degree <= 16; ++degree) {
    const TriangleRule rule = triangle_rule(degree);
    for (int a = 0; a <= degree; ++a)
      for (int b = 0; a + b <= degree; ++b)
        EXPECT_NEAR(integral_of_monomial(rule, a, b),
                    factorial(a) * factorial(b) / factorial(a + b + 2), rounding)
            << "degree " << degree << ", x^" << a << " y^" << b;
  }
}

TEST(TriangleRule, has_positive_weights_and_points_inside) {
  for (int degree = 0; degree <= 16; ++degree) {
    const TriangleRule rule = triangle_rule(degree);
    ASSERT_EQ(rule.points.cols(), rule.size());
    EXPECT_NEAR(rule.weights.sum(), 0.5, rounding);
    EXPECT_GT(rule.weights.minCoeff(), 0);
    EXPECT_GT(rule.points.minCoeff(), 0);
    EXPECT_LT(rule.points.colwise().sum().maxCoeff(), 1);
  }
}

TEST(SymmetricTriangleRule, is_exact_up_to_degree_10_and_no_further) {
  const TriangleRule rule = symmetric_triangle_rule();
  double beyond = 0;
  for (int a = 0; a <= 11; ++a)
    for (int b = 0; a + b <= 11; ++b) {
      const double error =
          integral_of_monomial(rule, a, b) - factorial(a) * factorial(b) / factorial(a + b + 2);
      if (a + b <= 10)
        EXPECT_NEAR(error, 0, 1e-15) << "x^" << a << " y^" << b;
      else
        beyond = std::max(beyond, std::abs(error));
    }
  EXPECT_GT(beyond, 1e-8);
}

TEST(SymmetricTriangleRule, has_positive_weights_and_points_inside) {
  const TriangleRule rule = symmetric_triangle_rule();
  ASSERT_EQ(rule.size(), 25);
  ASSERT_EQ(rule.points.cols(), 25);
  EXPECT_GT(rule.weights.minCoeff(), 0);
  EXPECT_GT(rule.points.minCoeff(), 0);
  EXPECT_LT(rule.points.colwise().sum().maxCoeff(), 1);
}

TEST(SymmetricTriangleRule, is_taken_to_itself_by_the_six_permutations_of_the_corners) {
  const TriangleRule rule = symmetric_triangle_rule();
  Eigen::Matrix3Xd coordinates(3, rule.size());  // barycentric
  coordinates << rule.points, 1 - rule.points.colwise().sum().array();
  std::array corners{0, 1, 2};
  do {
    std::vector<bool> taken(std::size_t(rule.size()), false);
    for (int k = 0; k < rule.size(); ++k) {
      const Eigen::Vector3d image = coordinates.col(k)(corners);
      Eigen::Index nearest = 0;
      EXPECT_LT((coordinates.colwise() - image).colwise().norm().minCoeff(&nearest), 1e-15);
      EXPECT_EQ(rule.weights[nearest], rule.weights[k]);
      EXPECT_FALSE(taken[std::size_t(nearest)]);
      taken[std::size_t(nearest)] = true;
    }
  } while (std::next_permutation(corners.begin(), corners.end()));
}

}  // namespace
}  // namespace sbeh::model
