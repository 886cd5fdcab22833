// Second-order automatic differentiation against closed forms, and against ceres::Jet to first order.
#include "model/numerics/second_order.h"

#include "model/energy_density.h"
#include "tests/model/general_material.h"

#include <ceres/jet.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace sbeh::model {
namespace {

using Number = SecondOrder<2>;
constexpr double x0 = 0.7, y0 = -1.3;
// Numbers of order 1 to 10, a few operations each.
constexpr double rounding = 100 * std::numeric_limits<double>::epsilon();

struct Expected {
  double value;
  Eigen::Vector2d gradient;
  double xx, xy, yy;
};

void expect_number(const Number& f, const Expected& expected) {
  Eigen::Matrix2d hessian;
  hessian << expected.xx, expected.xy, expected.xy, expected.yy;
  EXPECT_NEAR(f.a, expected.value, rounding);
  EXPECT_LT((f.g - expected.gradient).norm(), rounding);
  EXPECT_LT((f.h - hessian).norm(), rounding);
}

class SecondOrderOf : public testing::Test {
 protected:
  const Number x{x0, 0}, y{y0, 1};
};

TEST_F(SecondOrderOf, a_variable_and_of_a_constant) {
  expect_number(x, {x0, {1, 0}, 0, 0, 0});
  expect_number(y, {y0, {0, 1}, 0, 0, 0});
  expect_number(Number(3), {3, {0, 0}, 0, 0, 0});
  expect_number(Number(), {0, {0, 0}, 0, 0, 0});
}

TEST_F(SecondOrderOf, sums_and_differences) {
  expect_number(x * x + x * y, {x0 * x0 + x0 * y0, {2 * x0 + y0, x0}, 2, 1, 0});
  expect_number(x * x - x * y, {x0 * x0 - x0 * y0, {2 * x0 - y0, -x0}, 2, -1, 0});
  expect_number(-(x * y), {-x0 * y0, {-y0, -x0}, 0, -1, 0});
}

TEST_F(SecondOrderOf, a_product) {
  // x³y²
  expect_number(x * x * x * y * y, {std::pow(x0, 3) * y0 * y0,
                                    {3 * x0 * x0 * y0 * y0, 2 * std::pow(x0, 3) * y0},
                                    6 * x0 * y0 * y0,
                                    6 * x0 * x0 * y0,
                                    2 * std::pow(x0, 3)});
}

TEST_F(SecondOrderOf, a_quotient) {
  expect_number(x / y,
                {x0 / y0, {1 / y0, -x0 / (y0 * y0)}, 0, -1 / (y0 * y0), 2 * x0 / (y0 * y0 * y0)});
}

TEST_F(SecondOrderOf, a_root) {
  // r = √(x² + y²): ∂²r/∂x² = y²/r³, ∂²r/∂x∂y = −xy/r³.
  const double r = std::hypot(x0, y0), cube = r * r * r;
  expect_number(sqrt(x * x + y * y),
                {r, {x0 / r, y0 / r}, y0 * y0 / cube, -x0 * y0 / cube, x0 * x0 / cube});
}

TEST_F(SecondOrderOf, an_angle) {
  // φ = atan(y/x): ∂φ = (−y, x)/r², ∂²φ = (2xy, y² − x²; ., −2xy)/r⁴.
  const double square = x0 * x0 + y0 * y0, fourth = square * square;
  expect_number(atan(y / x), {std::atan(y0 / x0),
                              {-y0 / square, x0 / square},
                              2 * x0 * y0 / fourth,
                              (y0 * y0 - x0 * x0) / fourth,
                              -2 * x0 * y0 / fourth});
}

TEST_F(SecondOrderOf, mixtures_with_plain_numbers) {
  const double yy = y0 * y0;
  const Number f = x * y * y;  // gradient (y², 2xy), Hessian (0, 2y; 2y, 2x)
  const auto expected = [&](double value, double factor) {
    return Expected{
        value, {factor * yy, factor * 2 * x0 * y0}, 0, factor * 2 * y0, factor * 2 * x0};
  };
  expect_number(f + 3., expected(x0 * yy + 3, 1));
  expect_number(3. + f, expected(x0 * yy + 3, 1));
  expect_number(f - 3., expected(x0 * yy - 3, 1));
  expect_number(3. - f, expected(3 - x0 * yy, -1));
  expect_number(f * 3., expected(3 * x0 * yy, 3));
  expect_number(3. * f, expected(3 * x0 * yy, 3));
  expect_number(f / 4., expected(x0 * yy / 4, 0.25));
}

// The energy of a point of a surface, by all that it reads.
template <class T>
T energy(const T& beta, const T& slope, const T& stretch, const T& H, const T& r) {
  using std::sqrt;
  const T curvature = 1. / r;
  const auto density =
      energy_density(test::general_material(), beta, T(slope * slope / (stretch * stretch)), H,
                     T(curvature * (H - curvature)));
  return r * sqrt(stretch) * density.total() - 2. * (1. - H / 3.);
}

TEST(SecondOrder, of_the_energy_has_the_gradient_of_a_jet_and_the_differences_of_gradients) {
  constexpr int N = 5;
  using Jet = ceres::Jet<double, N>;
  using Point = Eigen::Matrix<double, N, 1>;
  using Second = SecondOrder<N>;
  const Point at = (Point() << 0.4, -0.8, 1.2, -1.7, 0.6).finished();
  const auto jet = [](const Point& p) {
    return energy(Jet(p[0], 0), Jet(p[1], 1), Jet(p[2], 2), Jet(p[3], 3), Jet(p[4], 4));
  };
  const Second f = energy(Second(at[0], 0), Second(at[1], 1), Second(at[2], 2), Second(at[3], 3),
                          Second(at[4], 4));
  EXPECT_NEAR(f.a, jet(at).a, rounding);
  EXPECT_LT((f.gradient() - jet(at).v).norm(), rounding);
  EXPECT_LT((f.hessian() - f.hessian().transpose()).norm(), rounding);
  // Central differences with h = 1e-5: truncation h² = 1e-10 and rounding 2⁻⁵²/h = 2e-11 times
  // derivatives of order 10.
  const double h = 1e-5;
  for (int k = 0; k < N; ++k) {
    const Point shift = h * Point::Unit(k);
    const Point column = (jet(at + shift).v - jet(at - shift).v) / (2 * h);
    EXPECT_LT((f.hessian().col(k) - column).norm(), 2e-9) << "column " << k;
  }
}

}  // namespace
}  // namespace sbeh::model
