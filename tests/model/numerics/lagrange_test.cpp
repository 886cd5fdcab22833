// Lagrange elements: nodal basis, node order, and exactness for polynomials of their order.
#include "model/numerics/lagrange.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>
#include <vector>

namespace sbeh::model {
namespace {

// Basis functions are products of at most three factors of at most 3 in size.
constexpr double rounding = 100 * std::numeric_limits<double>::epsilon();
constexpr int samples = 20;

// Of x^a, also at 0 and for a = 0.
double power(double x, int a) { return a == 0 ? 1 : std::pow(x, a); }
double power_slope(double x, int a) { return a == 0 ? 0 : a * power(x, a - 1); }
double power_bend(double x, int a) { return a < 2 ? 0 : a * (a - 1) * power(x, a - 2); }

class Interval : public testing::TestWithParam<int> {
 protected:
  IntervalElement element{GetParam()};
  std::mt19937 random{unsigned(GetParam())};
  double point() { return std::uniform_real_distribution<double>(0, 1)(random); }
};
INSTANTIATE_TEST_SUITE_P(of_order, Interval, testing::Values(1, 2, 3));

TEST_P(Interval, has_equidistant_nodes_in_order) {
  ASSERT_EQ(element.order(), GetParam());
  ASSERT_EQ(element.size(), GetParam() + 1);
  ASSERT_EQ(element.nodes().size(), element.size());
  for (int i = 0; i < element.size(); ++i)
    EXPECT_NEAR(element.nodes()[i], double(i) / GetParam(), rounding);
}

TEST_P(Interval, has_a_nodal_basis) {
  for (int j = 0; j < element.size(); ++j)
    EXPECT_LT(
        (element.values(element.nodes()[j]) - Eigen::VectorXd::Unit(element.size(), j)).norm(),
        rounding);
}

TEST_P(Interval, has_values_that_sum_to_one_and_derivatives_that_sum_to_zero) {
  for (int k = 0; k < samples; ++k) {
    const double x = point();
    EXPECT_NEAR(element.values(x).sum(), 1, rounding);
    EXPECT_NEAR(element.derivatives(x).sum(), 0, rounding);
  }
}

TEST_P(Interval, reproduces_polynomials_of_its_order_and_no_higher_ones) {
  for (int a = 0; a <= GetParam() + 1; ++a) {
    Eigen::VectorXd nodal(element.size());
    for (int i = 0; i < element.size(); ++i) nodal[i] = power(element.nodes()[i], a);
    double error = 0, slope_error = 0;
    for (int k = 0; k < samples; ++k) {
      const double x = point();
      error = std::max(error, std::abs(nodal.dot(element.values(x)) - power(x, a)));
      slope_error =
          std::max(slope_error, std::abs(nodal.dot(element.derivatives(x)) - power_slope(x, a)));
    }
    if (a <= GetParam()) {
      EXPECT_LT(error, rounding) << "x^" << a;
      EXPECT_LT(slope_error, rounding) << "x^" << a;
    } else {
      EXPECT_GT(error, 1e-3) << "x^" << a;
    }
  }
}

class Triangle : public testing::TestWithParam<int> {
 protected:
  TriangleElement element{GetParam()};
  std::mt19937 random{unsigned(GetParam())};
  Eigen::Vector2d point() {
    std::uniform_real_distribution<double> uniform(0, 1);
    const double x = uniform(random), y = uniform(random);
    return x + y < 1 ? Eigen::Vector2d(x, y) : Eigen::Vector2d(1 - x, 1 - y);
  }
};
INSTANTIATE_TEST_SUITE_P(of_order, Triangle, testing::Values(1, 2, 3));

TEST_P(Triangle, has_the_node_order_of_VTK) {
  // vtkLagrangeTriangle: corners; edges 01, 12, 20, each in its own direction; interior.
  static const std::vector<Eigen::Vector2d> lattice[3] = {
      {{0, 0}, {1, 0}, {0, 1}},
      {{0, 0}, {2, 0}, {0, 2}, {1, 0}, {1, 1}, {0, 1}},
      {{0, 0}, {3, 0}, {0, 3}, {1, 0}, {2, 0}, {2, 1}, {1, 2}, {0, 2}, {0, 1}, {1, 1}},
  };
  const auto& expected = lattice[GetParam() - 1];
  ASSERT_EQ(element.order(), GetParam());
  ASSERT_EQ(element.size(), int(expected.size()));
  const Eigen::Matrix2Xd nodes = element.nodes();
  ASSERT_EQ(nodes.cols(), element.size());
  for (int i = 0; i < element.size(); ++i)
    EXPECT_LT((nodes.col(i) - expected[i] / GetParam()).norm(), rounding) << "node " << i;
}

TEST_P(Triangle, has_a_nodal_basis) {
  const Eigen::Matrix2Xd nodes = element.nodes();
  for (int j = 0; j < element.size(); ++j)
    EXPECT_LT((element.values(nodes.col(j)) - Eigen::VectorXd::Unit(element.size(), j)).norm(),
              rounding);
}

TEST_P(Triangle, has_values_that_sum_to_one_and_derivatives_that_sum_to_zero) {
  for (int k = 0; k < samples; ++k) {
    const Eigen::Vector2d x = point();
    EXPECT_NEAR(element.values(x).sum(), 1, rounding);
    EXPECT_LT(element.derivatives(x).rowwise().sum().norm(), rounding);
  }
}

TEST_P(Triangle, reproduces_polynomials_of_its_order_and_no_higher_ones) {
  const Eigen::Matrix2Xd nodes = element.nodes();
  for (int degree = 0; degree <= GetParam() + 1; ++degree)
    for (int a = 0; a <= degree; ++a) {
      const int b = degree - a;
      Eigen::VectorXd nodal(element.size());
      for (int i = 0; i < element.size(); ++i)
        nodal[i] = power(nodes(0, i), a) * power(nodes(1, i), b);
      double error = 0, slope_error = 0, bend_error = 0;
      for (int k = 0; k < samples; ++k) {
        const Eigen::Vector2d x = point();
        const double value = power(x[0], a) * power(x[1], b);
        const Eigen::Vector3d bend(power_bend(x[0], a) * power(x[1], b),
                                   power_slope(x[0], a) * power_slope(x[1], b),
                                   power(x[0], a) * power_bend(x[1], b));
        bend_error = std::max(bend_error, (element.second_derivatives(x) * nodal - bend).norm());
        const Eigen::Vector2d slope(power_slope(x[0], a) * power(x[1], b),
                                    power(x[0], a) * power_slope(x[1], b));
        error = std::max(error, std::abs(nodal.dot(element.values(x)) - value));
        slope_error = std::max(slope_error, (element.derivatives(x) * nodal - slope).norm());
      }
      if (degree <= GetParam()) {
        EXPECT_LT(error, rounding) << "x^" << a << " y^" << b;
        EXPECT_LT(slope_error, rounding) << "x^" << a << " y^" << b;
        EXPECT_LT(bend_error, 10 * rounding) << "x^" << a << " y^" << b;
      } else {
        EXPECT_GT(error, 1e-3) << "x^" << a << " y^" << b;
      }
    }
}

TEST_P(Triangle, is_the_interval_element_on_each_edge) {
  // On edge 0→1 the corner nodes 0, 1 and the edge's own nodes are those of the interval.
  const int k = GetParam();
  const IntervalElement interval(k);
  for (const double x : {0.2, 0.55, 0.9}) {
    const Eigen::VectorXd line = interval.values(x), values = element.values({x, 0});
    EXPECT_NEAR(values[0], line[0], rounding);
    EXPECT_NEAR(values[1], line[k], rounding);
    for (int i = 1; i < k; ++i) EXPECT_NEAR(values[2 + i], line[i], rounding);
    for (int i = k + 2; i < element.size(); ++i) EXPECT_NEAR(values[i], 0, rounding);
  }
}

}  // namespace
}  // namespace sbeh::model
