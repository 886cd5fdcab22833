// Widest and middle circles of curves in closed form.
#include "axisym/circles.h"

#include "axisym/diagnostics.h"
#include "tests/axisym/cases.h"

namespace sbeh::axisym {
namespace {

using namespace test;

// Nodes at equal steps of the angle of (r, z)(θ).
template <class Curve>
Nodes curve_of(int elements, Curve&& point) {
  Nodes X(2, 3 * elements + 1);
  for (Eigen::Index i = 0; i < X.cols(); ++i)
    X.col(i) = point(pi * double(i) / double(X.cols() - 1));
  X(0, 0) = X(0, X.cols() - 1) = 0;
  return X;
}

// r = 3 sin θ − 2 sin³ θ: widest where sin θ = 1/√2.
Nodes dumbbell(int elements) {
  return curve_of(elements, [](double angle) {
    const double s = std::sin(angle);
    return Eigen::Vector2d(3 * s - 2 * s * s * s, 3 * std::cos(angle));
  });
}

Nodes egg(int elements) {
  return curve_of(elements, [](double angle) {
    return Eigen::Vector2d(std::sin(angle) * (1 + 0.3 * std::cos(angle)), std::cos(angle));
  });
}

TEST(Circles, of_a_dumbbell_are_its_waist_and_its_bulge) {
  OrderTable waist("radius of the waist", "h"), bulge("radius of the bulge", "h");
  for (const int elements : {25, 51, 101}) {  // the waist is within an element
    const Nodes X = dumbbell(elements);
    const Field z = X.row(1);  // as a field, it tells where
    waist.add(1. / elements, middle_circle(X, z).radius - 1);
    bulge.add(1. / elements, widest_circle(X, z).radius - std::sqrt(2.));
    EXPECT_NEAR(middle_circle(X, z).H, 0, 1e-14);
    EXPECT_NEAR(std::abs(widest_circle(X, z).H), 3 / std::sqrt(2.), 1e-3);
  }
  for (const auto& table : {waist, bulge})
    for (const double order : table.orders()) EXPECT_GT(order, 3.5);
}

TEST(Circles, of_a_sphere_are_the_same) {
  for (const int elements : {16, 17, 48}) {
    const Nodes X = spheroid(1., 1., elements, 0.5);
    const Field H = Field::Constant(X.cols(), -2);
    EXPECT_NEAR(middle_circle(X, H).radius, widest_circle(X, H).radius,
                std::pow(pi / elements, 4));  // the cubics' own error
  }
}

TEST(Circles, measured_on_a_shape_without_symmetry_are_the_widest) {
  const Nodes X = egg(60);
  const Diagnostics d = diagnose({}, {X, Field::Constant(X.cols(), model::full_order)});
  // cos θ + 0.3 cos 2θ = 0
  const double c = (-1 + std::sqrt(1 + 4 * 0.6 * 0.3)) / 1.2;
  EXPECT_NEAR(d.radius_equator, std::sqrt(1 - c * c) * (1 + 0.3 * c), 1e-7);
}

TEST(Circles, measured_on_a_dumbbell_are_the_waist_and_the_curvature_of_the_bulge) {
  const auto measured = [](int elements) {
    const Nodes X = dumbbell(elements);
    return diagnose({}, {X, Field::Constant(X.cols(), model::full_order)});
  };
  OrderTable waist("radius_equator", "h"), curvature("H_rim", "h");
  for (const int elements : {25, 51, 101})  // the waist in the middle of an element
    waist.add(1. / elements, measured(elements).radius_equator - 1);
  // κ = |r''| / z'² with r'' = −3√2, z' = −3/√2.
  const double H = -(1 / std::sqrt(2.) + 2 * std::sqrt(2.) / 3);
  for (const int elements : {26, 50, 102})  // the bulge in the middle of one
    curvature.add(1. / elements, measured(elements).H_rim - H);
  for (const double order : waist.orders()) EXPECT_GT(order, 3.5);
  for (const double order : curvature.orders()) EXPECT_GT(order, 1.8);
}

}  // namespace
}  // namespace sbeh::axisym
