// The gradient of axisym/weak_form.h against that of a three-dimensional field, and its transpose.
#include "axisym/weak_form.h"
#include "tests/model/analytic_surface.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace sbeh::axisym {
namespace {

using model::test::directions;
using model::test::Example;
using model::test::examples;
using model::test::Point;
using model::test::surface_point;
using model::test::SurfacePoint;
using model::test::unit_sphere;

constexpr double epsilon = std::numeric_limits<double>::epsilon();
const Example& bumpy = examples[0];

// (W_r, W_z) and its derivative by θ of a field that is given at longitude 0.
struct Meridian {
  Eigen::Vector2d value, derivative;
  explicit Meridian(const Point& at_zero)
      : value(at_zero[0].derivative(0, 0).a, at_zero[2].derivative(0, 0).a),
        derivative(at_zero[0].derivative(1, 0).a, at_zero[2].derivative(1, 0).a) {}
};

// The generating curve with θ as its coordinate, as curve_point would give it.
CurvePoint meridian_point(double theta) {
  const Meridian X(bumpy.position(unit_sphere(theta, 0)));
  CurvePoint p{};
  p.x = X.value;
  p.dx = X.derivative;
  p.stretch = p.dx.norm();
  p.t = p.dx / p.stretch;
  p.nu << -p.t[1], p.t[0];
  p.B_phi = -p.nu[0] / p.x[0];
  return p;
}

const auto angles = {0.1, 0.7, 1.6, 2.4, 3.1};  // the poles are at 0 and π
constexpr double rounding = 1000 * epsilon;     // of numbers O(1), some divided by r >= 0.03

TEST(AxisymmetricGradient, is_the_gradient_of_the_field_in_space_at_every_longitude) {
  for (const double theta : angles) {
    const Meridian W(bumpy.displacement(unit_sphere(theta, 0)));
    const auto grad = surface_gradient<double>(meridian_point(theta), W.value, W.derivative);
    for (const double phi : {0.0, 1.3, 4.0}) {
      const Point n = unit_sphere(theta, phi);
      const SurfacePoint p = surface_point(bumpy.position(n));
      EXPECT_LT((grad - p.gradient(bumpy.displacement(n))).norm(), rounding);
    }
  }
}

TEST(AxisymmetricGradient, stands_in_the_frame_of_tangent_longitude_and_normal) {
  for (const double theta : angles) {
    const CurvePoint x = meridian_point(theta);
    const SurfacePoint p = surface_point(bumpy.position(unit_sphere(theta, 0)));
    Eigen::Matrix3d frame;
    frame << x.t[0], 0, x.nu[0],  //
        0, 1, 0,                  //
        x.t[1], 0, x.nu[1];
    EXPECT_LT((frame - p.frame).norm(), rounding);
  }
}

TEST(AxisymmetricShapeOperator, follows_from_trace_and_longitude) {
  for (const double theta : angles) {
    const SurfacePoint p = surface_point(bumpy.position(unit_sphere(theta, 0)));
    EXPECT_LT((shape_operator(p.H, meridian_point(theta).B_phi) - p.B).norm(), rounding);
  }
}

TEST(AxisymmetricGradient, has_its_transpose_in_test_with_gradient) {
  // (S, ∇_C W) is linear in W and W': its factors against the gradient of every unit field.
  model::Gradient<double> S;
  S << 0.3, -0.7, 1.1, 0.9, -0.4, 0.6;
  for (const double theta : angles) {
    const CurvePoint x = meridian_point(theta);
    Eigen::Vector2d factor(0.5, -0.25), derivative_factor(2, 4);  // added to, not overwritten
    test_with_gradient<double>(x, S, factor, derivative_factor);
    for (int k = 0; k < 2; ++k) {
      const Eigen::Vector2d unit = Eigen::Vector2d::Unit(k), zero = Eigen::Vector2d::Zero();
      const double by_value = surface_gradient<double>(x, unit, zero).cwiseProduct(S).sum();
      const double by_slope = surface_gradient<double>(x, zero, unit).cwiseProduct(S).sum();
      EXPECT_NEAR(factor[k], by_value + (k == 0 ? 0.5 : -0.25), rounding);
      EXPECT_NEAR(derivative_factor[k], by_slope + (k == 0 ? 2 : 4), rounding);
    }
  }
}

}  // namespace
}  // namespace sbeh::axisym
