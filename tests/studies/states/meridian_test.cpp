// Meridians through points: distances, lengths and curvatures against closed forms.
#include "studies/states/meridian.h"

#include "axisym/start_shapes.h"
#include "tests/order_table.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace sbeh::studies {
namespace {

using std::numbers::pi;

// The unit sphere; the points are closer to each other towards the first pole.
Meridian sphere(int points, double stretch = 0) {
  Eigen::Matrix2Xd X(2, points);
  Eigen::VectorXd order(points);
  for (int i = 0; i < points; ++i) {
    const double x = pi * i / (points - 1), angle = x - stretch * std::sin(x);
    X.col(i) << std::sin(angle), std::cos(angle);
    order[i] = 0.5 + 0.1 * std::cos(2 * angle);
  }
  X(0, 0) = X(0, points - 1) = 0;
  return Meridian(X, order);
}

// Half of the sphere in steps twice as long as those of the other half.
Meridian sphere_of_two_spacings(int points) {
  const int below = points / 2;
  Eigen::Matrix2Xd X(2, points + below);
  for (int i = 0; i < points + below; ++i) {
    const double angle =
        i < points ? pi / 2 * i / (points - 1) : pi / 2 * (1 + double(i - points + 1) / below);
    X.col(i) << std::sin(angle), std::cos(angle);
  }
  return Meridian(X, Eigen::VectorXd::Constant(points + below, 0.5), {points - 1});
}

double largest_distance_from_the_sphere(const Meridian& curve) {
  double largest = 0;
  for (double t = 0; t < double(curve.points().cols() - 1); t += 0.13)
    largest = std::max(largest, std::abs(curve.at(t).norm() - 1));
  return largest;
}

TEST(Meridian, through_points_of_a_sphere_is_one_to_the_eighth_order) {
  sbeh::test::OrderTable table("distance of the curve from the sphere", "h");
  for (const int points : {17, 33, 65})
    table.add(1. / (points - 1), largest_distance_from_the_sphere(sphere(points, 0.3)));
  EXPECT_GT(table.print(), 7.5);
}

TEST(Meridian, does_not_reach_across_a_joint) {
  EXPECT_LT(largest_distance_from_the_sphere(sphere_of_two_spacings(64)), 1e-11);
}

TEST(Meridian, of_a_sphere_has_its_length_curvature_and_mean_order) {
  for (const double stretch : {0., 0.4}) {
    const Meridian curve = sphere(129, stretch);
    EXPECT_NEAR(curve.arc_length(128), pi, 1e-12);
    EXPECT_NEAR(curve.arc_length(64.5) + curve.reversed().arc_length(63.5), pi, 1e-12);
    for (const double H : curve.pole_curvatures()) EXPECT_NEAR(H, -2, 1e-8);
    // ∫ cos 2θ dS / 4π = −1/3
    EXPECT_NEAR(curve.mean_order(), 0.5 - 0.1 / 3, 1e-12);
    EXPECT_NEAR(curve.largest_order(), 0.6, 1e-12);
  }
}

TEST(Meridian, finds_the_nearest_point_on_either_side) {
  const Meridian curve = sphere(129);
  for (const double angle : {0., 0.01, 1.1, 2.9, pi})
    for (const double r : {0.9, 1., 1.2}) {
      const Eigen::Vector2d x(r * std::sin(angle), r * std::cos(angle));
      const double t = curve.nearest(x);
      EXPECT_NEAR(curve.arc_length(t), angle, 1e-9);
      EXPECT_NEAR(curve.normal_distance(t, x), r - 1, 1e-12);
    }
}

TEST(Meridian, of_elements_is_that_of_its_points_and_turned_over_is_the_same) {
  const axisym::Nodes X = axisym::spheroid(0.7, false, 48, 0.5);
  const Meridian elements(axisym::State{X, axisym::Field::Constant(X.cols(), 0.6)});
  EXPECT_LT(distance(elements, elements), 1e-14);
  EXPECT_LT(distance(elements.centred(), elements.reversed().centred()), 1e-10);
  EXPECT_NEAR(elements.mean_order(), 0.6, 1e-14);
}

TEST(Meridian, needs_an_order_for_every_point) {
  EXPECT_THROW(Meridian(Eigen::Matrix2Xd::Zero(2, 9), Eigen::VectorXd::Zero(8)),
               std::invalid_argument);
  EXPECT_THROW(Meridian(Eigen::Matrix2Xd::Zero(2, 9), Eigen::VectorXd::Zero(9), {7}),
               std::invalid_argument);
}

}  // namespace
}  // namespace sbeh::studies
