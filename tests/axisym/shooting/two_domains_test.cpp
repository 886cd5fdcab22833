// Vesicles of two domains by shooting: what is known of them without shooting.
#include "tests/axisym/shooting/two_domains.h"

#include "axisym/shooting/seifert_shooting.h"
#include "model/numerics/root.h"
#include "tests/order_table.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>

namespace sbeh::axisym::shooting {
namespace {

using sbeh::test::OrderTable;
using std::numbers::pi;

// A soft cap.
constexpr TwoDomains soft{.fraction = 0.2,
                          .kappa_a = 0.2,
                          .kappa_b = 1,
                          .gauss_jump = 0.3,
                          .line_tension = 3,
                          .reduced_volume = 0.85};

TEST(TwoDomains, that_do_not_differ_are_the_prolate) {
  for (const double V : {0.95, 0.8}) {
    const ClassicalShape prolate = shoot_branch(Branch::prolate, std::array{V}).front();
    const TwoDomainVesicle v = open_vesicle({.fraction = 0.3, .reduced_volume = V});
    EXPECT_NEAR(v.energy, 8 * pi * prolate.energy, 1e-9);
    EXPECT_NEAR(v.pressure, prolate.pressure, 1e-9);
    EXPECT_NEAR(v.tension_a, prolate.tension, 1e-9);
    EXPECT_NEAR(v.tension_b, prolate.tension, 1e-9);
  }
}

// Only the line tension has an energy that goes with the size.
TEST(TwoDomains, fulfil_the_virial_theorem) {
  const TwoDomainVesicle v = open_vesicle(soft);
  const double A = 4 * pi, x = soft.fraction, V = 4 * pi / 3 * soft.reduced_volume,
               length = 2 * pi * v.interface_radius;
  EXPECT_NEAR(2 * A * (x * v.tension_a + (1 - x) * v.tension_b) + soft.line_tension * length,
              3 * v.pressure * V, 1e-8);
}

// ∂U/∂V = P, ∂U/∂A_i = −Σ_i, ∂U/∂λ = the length of the interface, ∂U/∂Δ = ∫_a K dS.
TEST(TwoDomains, change_their_energy_by_what_is_conjugate) {
  const TwoDomainVesicle v = open_vesicle(soft);
  const struct {
    const char* name;
    double TwoDomains::*parameter;
    double expected;
  } cases[] = {
      {"V_r", &TwoDomains::reduced_volume, 4 * pi / 3 * v.pressure},
      {"fraction", &TwoDomains::fraction, 4 * pi * (v.tension_b - v.tension_a)},
      {"line tension", &TwoDomains::line_tension, 2 * pi * v.interface_radius},
      {"jump of kappa_G", &TwoDomains::gauss_jump, 2 * pi * (1 - std::cos(v.interface_angle))}};
  for (const auto& c : cases) {
    const auto energy = [&](double change) {
      TwoDomains of = soft;
      of.*c.parameter += change;
      return open_vesicle(of).energy;
    };
    constexpr double h = 2e-3;
    const double near = (energy(h) - energy(-h)) / (2 * h),
                 far = (energy(2 * h) - energy(-2 * h)) / (4 * h);
    // What is left is of fourth order: a small part of the difference of both.
    EXPECT_NEAR((4 * near - far) / 3, c.expected, 1e-2 * std::abs(near - far) + 1e-8) << c.name;
  }
}

// The radius of the circle in which two spherical caps of these areas and this volume meet.
double circle_of_caps(double fraction, double reduced_volume) {
  const auto missing = [&](double radius) {
    double volume = 0;
    for (const double area : {4 * pi * fraction, 4 * pi * (1 - fraction)}) {
      const double h = std::sqrt(area / pi - radius * radius);
      volume += pi * h * (3 * radius * radius + h * h) / 6;
    }
    return volume - 4 * pi / 3 * reduced_volume;
  };
  return model::root_between(missing, 0, std::sqrt(2 * fraction)).middle();
}

// Bending rounds the kink between them over a width that falls with the root of κ over the tension.
TEST(TwoDomains, become_two_caps_as_the_line_tension_grows) {
  OrderTable table("radius of the interface, from that of two spherical caps", "1/lambda");
  const double circle = circle_of_caps(soft.fraction, 0.95);
  for (const double lambda : {6., 12., 24.})
    table.add(1 / lambda, open_vesicle({.fraction = soft.fraction,
                                        .kappa_a = soft.kappa_a,
                                        .line_tension = lambda,
                                        .reduced_volume = 0.95})
                                      .interface_radius
                                  / circle
                              - 1);
  EXPECT_GT(table.print(), 0.5);
}

// The line tension at which the soft cap buds at a fold, and the volume of two spheres.
constexpr double folding = 2.6;
double volume_of_spheres(double x) { return std::pow(x, 1.5) + std::pow(1 - x, 1.5); }

// The bud at this V_r, by way of a line tension with which the neck stays open.
TwoDomainVesicle bud(double reduced_volume) {
  const TwoDomains open{
      .fraction = 0.2, .kappa_a = 0.2, .line_tension = 2.4, .reduced_volume = 0.95};
  TwoDomains deflated = open;
  deflated.reduced_volume = 0.785;
  TwoDomains tight = deflated;
  tight.line_tension = folding;
  TwoDomains of = tight;
  of.reduced_volume = reduced_volume;
  return vesicle_along(std::array{open, deflated, tight, of});
}

// V_r = x^1.5 + (1 − x)^1.5, U = 8π(κ_a + κ_b). The neck of the bud is open at smaller volumes.
TEST(TwoDomains, become_two_spheres_as_the_neck_closes) {
  OrderTable volumes("V_r, from that of two spheres", "neck"),
      energies("energy, from that of two spheres", "neck");
  for (const double below : {8e-4, 4e-4, 2e-4, 1e-4, 5e-5}) {
    const TwoDomainVesicle v = bud(volume_of_spheres(0.2) - below);
    ASSERT_FALSE(v.is_fold);
    volumes.add(v.neck_radius, below);
    energies.add(v.neck_radius, v.energy - 8 * pi * (0.2 + 1));
  }
  // a² and a, with logarithms of a.
  EXPECT_GT(volumes.print(), 1.5);
  EXPECT_GT(energies.print(), 0.75);
}

TEST(TwoDomains, bud_at_a_fold_for_a_line_tension_between) {
  const auto towards = [](double lambda) {
    return open_vesicle(
        {.fraction = 0.2, .kappa_a = 0.2, .line_tension = lambda, .reduced_volume = 0.8});
  };
  EXPECT_FALSE(towards(2).is_fold);  // an open neck
  const TwoDomainVesicle fold = towards(folding);
  ASSERT_TRUE(fold.is_fold);
  EXPECT_LT(fold.reduced_volume, volume_of_spheres(0.2));
  const TwoDomainVesicle beyond = bud(fold.reduced_volume);
  std::printf("neck %.4f at the fold, %.4f of the bud\n", fold.neck_radius, beyond.neck_radius);
  EXPECT_LT(beyond.neck_radius, fold.neck_radius / 2);
  EXPECT_LT(beyond.energy, fold.energy);
}

}  // namespace
}  // namespace sbeh::axisym::shooting
