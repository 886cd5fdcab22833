// Areas of spheroids against limits and quadrature.
#include "model/numerics/spheroid.h"

#include "model/numerics/quadrature.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace sbeh::model {
namespace {

using std::numbers::pi;
constexpr double epsilon = std::numeric_limits<double>::epsilon();

TEST(Spheroid, has_the_area_of_disc_and_sphere_and_nearly_that_of_a_needle) {
  EXPECT_NEAR(spheroid_area(1e-7), 2 * pi, 2e-12);  // and 2π q² ln(2/q)
  EXPECT_EQ(spheroid_area(1), 4 * pi);
  EXPECT_NEAR(spheroid_area(1e8) / 1e8, pi * pi, 1e-7);  // relative error 1/q
  EXPECT_NEAR(spheroid_reduced_volume(1), 1, 2 * epsilon);
}

TEST(Spheroid, has_an_area_that_is_smooth_through_the_sphere) {
  // A(1 + h) = 4π(1 + 2h/3) + O(h²).
  for (const double h : {-1e-7, -1e-10, -1e-12, 1e-12, 1e-10, 1e-7})
    EXPECT_NEAR(spheroid_area(1 + h), 4 * pi * (1 + 2 * h / 3), 4 * pi * (h * h + 20 * epsilon))
        << h;
}

TEST(Spheroid, has_the_area_of_its_integral) {
  // ∫2π sin θ √(cos²θ + q² sin²θ) dθ, analytic in cos θ.
  const IntervalRule rule = gauss_rule(40);
  for (const double q : {0.5, 0.8, 1.3, 2.}) {
    double area = 0;
    for (int i = 0; i < rule.size(); ++i) {
      const double c = 2 * rule.points[i] - 1;
      area += 4 * pi * rule.weights[i] * std::sqrt(c * c + q * q * (1 - c * c));
    }
    EXPECT_NEAR(spheroid_area(q), area, 1e-13 * area) << q;
  }
}

TEST(Spheroid, is_found_by_its_reduced_volume) {
  for (const bool prolate : {false, true})
    for (const double v : {0.01, 0.3, 0.65, 0.95, 0.999999}) {
      const double q = spheroid_axis_ratio(v, prolate);
      EXPECT_EQ(q > 1, prolate);
      EXPECT_NEAR(spheroid_reduced_volume(q), v, 1e-13 * v);
    }
  EXPECT_EQ(spheroid_axis_ratio(1, true), 1);
}

}  // namespace
}  // namespace sbeh::model
