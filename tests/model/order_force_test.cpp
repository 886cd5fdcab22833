// The order force of model/terms.h is the derivative of the energy of model/energy_density.h by the
// order, per label.
#include "model/energy_density.h"
#include "model/terms.h"
#include "tests/model/analytic_surface.h"
#include "tests/model/finite_difference.h"
#include "tests/model/order_cases.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace sbeh::model {
namespace {

using namespace test;

// The energy density at order β + amount · ψ.
double changed_density(const Material& m, const Example& example, double amount,
                       const SurfacePoint& p, const Point& n) {
  const Taylor beta = example.order(n) + amount * example.order_change(n);
  return energy_density(m, beta.derivative(0, 0).a, p.gradient(beta).squaredNorm(), p.H, p.K())
      .total();
}

class OrderForce : public testing::TestWithParam<Example> {};

// Any quadrature will do, because the energy and its derivative see the same points. Along ψ the
// energy is a polynomial of degree 6, for which the extrapolated difference is exact but for
// rounding: 2⁻⁵² times the root of the number of points, 17, divided by the smallest step, 1/16,
// and times the sum of the weights, 2.
constexpr int points = 12;
constexpr double step = 0.5, tolerance = 17 * 16 * 2 * std::numeric_limits<double>::epsilon();

TEST_P(OrderForce, is_the_derivative_of_the_energy_by_the_order) {
  const Example& example = GetParam();
  const auto all = directions(example.axisymmetric, points);
  for (const auto& [label, material] : order_cases()) {
    const Material& m = material;
    const double derivative = derivative_at_zero(
        [&](double amount) {
          return integral(example, all, [&](const SurfacePoint& p, const Point& n) {
            return changed_density(m, example, amount, p, n);
          });
        },
        step);
    const double magnitude = integral(example, all, [&](const SurfacePoint& p, const Point& n) {
      return std::abs(changed_density(m, example, step, p, n));
    });
    const double distortion = integral(example, all, [&](const SurfacePoint& p, const Point& n) {
      return m.l1()
           * p.gradient(example.order(n)).dot(p.gradient(example.order_change(n)));  // (B2)
    });
    const double reaction = integral(example, all, [&](const SurfacePoint& p, const Point& n) {
      const double beta = example.order(n).derivative(0, 0).a;
      return order_force(m, beta, p.H, p.K()) * example.order_change(n).derivative(0, 0).a;
    });
    EXPECT_NEAR(derivative, distortion + reaction, tolerance * magnitude) << label;
    EXPECT_GT(std::abs(derivative), 1e-3 * magnitude) << label << " does nothing in this example";
  }
}

INSTANTIATE_TEST_SUITE_P(on, OrderForce, testing::ValuesIn(examples),
                         [](const auto& example) { return std::string(example.param.name); });

}  // namespace
}  // namespace sbeh::model
