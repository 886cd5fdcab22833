// The kinematic helpers of model/terms.h and the analytic surfaces that the tests stand on.
#include "model/terms.h"

#include "tests/model/analytic_surface.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <string>

namespace sbeh::model {
namespace {

using namespace test;
using std::numbers::pi;

constexpr double epsilon = std::numeric_limits<double>::epsilon();

// 48 Gauss points leave rounding in the integrals, which are all of order 10.
constexpr int points = 48;
constexpr double tolerance = 1000 * epsilon;

class Surface : public testing::TestWithParam<Example> {
 protected:
  const Example& example() const { return GetParam(); }
  template <class Integrand>
  double integrate(const Integrand& f) const {
    return integral(example(), directions(example().axisymmetric, points), f);
  }
};

TEST_P(Surface, obeys_Gauss_and_Bonnet) {
  EXPECT_NEAR(integrate([](const SurfacePoint& p, const Point&) { return gauss_curvature(p.B); }),
              4 * pi, tolerance);
}

TEST_P(Surface, has_the_Gaussian_curvature_of_its_trace_and_norm) {
  for (const Direction& d : directions(example().axisymmetric, 5)) {
    const SurfacePoint p = surface_point(example().position(d.n));
    EXPECT_NEAR(p.B.trace(), p.H, 100 * epsilon);
    EXPECT_NEAR(gauss_curvature(p.B), (p.H * p.H - p.B.squaredNorm()) / 2, 100 * epsilon);
  }
}

TEST_P(Surface, turns_its_normal_by_the_shape_operator) {
  // B = −∇_C ν, here by central differences of ν: h² = 1e-10 times third derivatives of order 10.
  const double h = 1e-5;
  const Example& e = example();
  for (double theta : {0.4, 1.5, 2.9})
    for (double phi : {0.2, 3.7}) {
      const auto normal = [&](double t, double f) -> Eigen::Vector3d {
        return surface_point(e.position(unit_sphere(t, f))).frame.col(2);
      };
      const SurfacePoint p = surface_point(e.position(unit_sphere(theta, phi)));
      Eigen::Matrix<double, 2, 3> derivative;
      derivative.row(0) = (normal(theta + h, phi) - normal(theta - h, phi)) / (2 * h);
      derivative.row(1) = (normal(theta, phi + h) - normal(theta, phi - h)) / (2 * h);
      const Gradient<double> grad_nu = (p.inverse * derivative * p.frame).transpose();
      EXPECT_LT((grad_nu.topRows<2>() + p.B).norm(), 1e-8);
      EXPECT_LT(grad_nu.row(2).norm(), 1e-8);
    }
}

TEST_P(Surface, has_total_divergence_by_mean_curvature) {
  // ∫ Div_C W dS = −∫ H W·ν dS on a closed surface; with W = X, Minkowski's −∫ H X·ν dS = 2A.
  for (const auto& W : {example().displacement, example().position}) {
    const double divergence_of_W = integrate(
        [&](const SurfacePoint& p, const Point& n) { return divergence(p.gradient(W(n))); });
    const double flux = integrate(
        [&](const SurfacePoint& p, const Point& n) { return p.H * p.components(W(n))[2]; });
    EXPECT_NEAR(divergence_of_W, -flux, tolerance);
  }
}

TEST_P(Surface, has_the_gradient_of_its_mean_curvature) {
  // ∫ Div_C (H W) dS = −∫ H² W·ν dS.
  const double left = integrate([&](const SurfacePoint& p, const Point& n) {
    const Point W = example().displacement(n);
    return p.grad_H.dot(p.components(W).head<2>()) + p.H * divergence(p.gradient(W));
  });
  const double right = integrate([&](const SurfacePoint& p, const Point& n) {
    return p.H * p.H * p.components(example().displacement(n))[2];
  });
  EXPECT_NEAR(left, -right, tolerance);
}

TEST_P(Surface, is_strained_by_growth_alone_and_not_by_rotation) {
  for (const Direction& d : directions(example().axisymmetric, 5)) {
    const Point X = example().position(d.n);
    const SurfacePoint p = surface_point(X);
    const Gradient<double> growth = p.gradient(X);
    EXPECT_LT((growth.topRows<2>() - Eigen::Matrix2d::Identity()).norm(), 100 * epsilon);
    EXPECT_LT((rate_of_strain(growth) - 2 * Eigen::Matrix2d::Identity()).norm(), 100 * epsilon);
    EXPECT_NEAR(divergence(growth), 2, 100 * epsilon);

    const Taylor a = 0.3, b = -0.8, c = 0.5;  // ω × X
    const Gradient<double> rotation =
        p.gradient(Point{b * X[2] - c * X[1], c * X[0] - a * X[2], a * X[1] - b * X[0]});
    EXPECT_LT(rate_of_strain(rotation).norm(), 100 * epsilon);
    EXPECT_NEAR(divergence(rotation), 0, 100 * epsilon);
  }
}

INSTANTIATE_TEST_SUITE_P(on, Surface, testing::ValuesIn(examples),
                         [](const auto& example) { return std::string(example.param.name); });

TEST(UnitSphere, has_curvature_minus_two_and_shape_operator_minus_identity) {
  const SurfacePoint p = surface_point(unit_sphere(0.8, 2.1));
  EXPECT_NEAR(p.H, -2, 10 * epsilon);
  EXPECT_LT((p.B + Eigen::Matrix2d::Identity()).norm(), 10 * epsilon);
  EXPECT_NEAR(gauss_curvature(p.B), 1, 10 * epsilon);
  EXPECT_LT(p.grad_H.norm(), 20 * epsilon);
  const Eigen::Vector3d n(std::sin(0.8) * std::cos(2.1), std::sin(0.8) * std::sin(2.1),
                          std::cos(0.8));
  EXPECT_LT((p.frame.col(2) - n).norm(), 10 * epsilon) << "the normal points outward";
}

TEST(Surface, without_symmetry_has_tensors_without_zeros) {
  const Example& e = examples[1];
  const SurfacePoint p = surface_point(e.position(unit_sphere(1.1, 0.6)));
  EXPECT_GT(p.B.cwiseAbs().minCoeff(), 1e-2);
  EXPECT_GT(p.gradient(e.displacement(unit_sphere(1.1, 0.6))).cwiseAbs().minCoeff(), 1e-2);
}

}  // namespace
}  // namespace sbeh::model
