// The labelled stresses of model/terms.h are minus the derivative of the energy of
// model/energy_density.h by the shape, per part of the energy.
#include "model/energy_density.h"
#include "model/terms.h"
#include "tests/model/analytic_surface.h"
#include "tests/model/energy_parts.h"
#include "tests/model/finite_difference.h"
#include "tests/model/general_material.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace sbeh::model {
namespace {

using namespace test;

// The second example has κ and κ_G of its own.
Material material_of(const Example& example) {
  return example.axisymmetric ? general_material() : given_material();
}

Density density_at(const Example& example, const SurfacePoint& p,
                   const ElasticPoint<double, double>& x) {
  return energy_density(material_of(example), x.beta, x.grad_beta.squaredNorm(), p.H, p.K());
}

// The energy parts of the surface X + amount · W, every material point keeping its order.
Parts energy_of_displaced(const Example& example, const std::vector<Direction>& directions,
                          double amount) {
  Parts sum = Parts::Zero();
  for (const Direction& d : directions) {
    const Point X = example.position(d.n), W = example.displacement(d.n);
    const SurfacePoint p =
        surface_point({X[0] + amount * W[0], X[1] + amount * W[1], X[2] + amount * W[2]});
    const Density density = density_at(example, p, p.with_order(example.order(d.n)));
    const double dS = p.area / d.sin_theta * d.weight;
    for (std::size_t k = 0; k < parts().size(); ++k)
      sum[Eigen::Index(k)] += dS * density.*parts()[k].density;
  }
  return sum;
}

// Of one part: the power of each term, that of e, and how much of both cancels in the integral.
struct Power {
  std::vector<double> terms;  ///< (T, ∇_C W)
  double isotropic = 0;       ///< (e, Div_C W), or 0
  double magnitude = 0;       ///< ∫ Σ|T : ∇_C W| + |e Div_C W| + |e| dS
  double total() const {
    double sum = -isotropic;
    for (const double term : terms) sum += term;
    return sum;
  }
};

Power power_of(const Part& part, const Example& example, const std::vector<Direction>& directions) {
  Power power{.terms = std::vector<double>(part.terms.size())};
  for (const Direction& d : directions) {
    const SurfacePoint p = surface_point(example.position(d.n));
    const auto x = p.with_order(example.order(d.n));
    const Gradient<double> grad_W = p.gradient(example.displacement(d.n));
    const double dS = p.area / d.sin_theta * d.weight;
    const double e = density_at(example, p, x).*part.density;
    for (std::size_t k = 0; k < part.terms.size(); ++k) {
      const double density = contract(part.terms[k].stress(material_of(example), x), grad_W);
      power.terms[k] += dS * density;
      power.magnitude += dS * std::abs(density);
    }
    if (part.isotropic) power.isotropic += dS * e * divergence(grad_W);
    power.magnitude += dS * std::abs(e) * (1 + std::abs(divergence(grad_W)));
  }
  return power;
}

// 48 Gauss points (and 96 around) leave rounding: 24 leave 5e-10, and doubling squares the error.
// As functions of ε the energies are analytic up to where the displaced surface degenerates, not
// before |ε| = 1/2. So the differences, extrapolated from h = 0.04, have a truncation error of
// (0.04 · 0.02 · 0.01 · 0.005)² 2⁸ = 4e-13 and a rounding error of 2⁻⁵²/0.005 · 2 = 9e-14, times
// about ten for the cancellation in the curvatures.
constexpr int points = 48;
constexpr double epsilon = std::numeric_limits<double>::epsilon();
constexpr double step = 0.04, tolerance = 2e-12;

class ElasticStress : public testing::TestWithParam<Example> {};

TEST_P(ElasticStress, is_minus_the_derivative_of_every_part_of_the_energy) {
  const Example& example = GetParam();
  const auto all = directions(example.axisymmetric, points);
  const Parts derivative = derivative_at_zero(
      [&](double amount) { return energy_of_displaced(example, all, amount); }, step);
  for (std::size_t k = 0; k < parts().size(); ++k) {
    const Power power = power_of(parts()[k], example, all);
    EXPECT_NEAR(derivative[Eigen::Index(k)], -power.total(), tolerance * power.magnitude)
        << parts()[k].label;
  }
}

// Without one of them the identity above would be off by its power.
TEST_P(ElasticStress, needs_every_single_term) {
  const Example& example = GetParam();
  const auto all = directions(example.axisymmetric, points);
  for (const Part& part : parts()) {
    const Power power = power_of(part, example, all);
    for (std::size_t k = 0; k < part.terms.size(); ++k)
      EXPECT_GT(std::abs(power.terms[k]), 1e-3 * power.magnitude) << part.terms[k].label;
    if (part.isotropic) {
      EXPECT_GT(std::abs(power.isotropic), 1e-3 * power.magnitude) << part.label;
    }
  }
}

TEST_P(ElasticStress, is_the_sum_of_its_labelled_terms_which_are_all_in_the_table) {
  const Example& example = GetParam();
  for (const Direction& d : directions(example.axisymmetric, 6)) {
    const SurfacePoint p = surface_point(example.position(d.n));
    const auto x = p.with_order(example.order(d.n));
    Gradient<double> sum = Gradient<double>::Zero(), magnitude = sum;
    for (const Part& part : parts())
      for (const Term& term : part.terms) {
        const Gradient<double> stress = term.stress(material_of(example), x);
        sum += stress;
        magnitude += stress.cwiseAbs();
      }
    const Gradient<double> error = (elastic_stress(material_of(example), x) - sum).cwiseAbs();
    // Two orders of summation of six numbers.
    EXPECT_TRUE((error.array() <= 10 * epsilon * magnitude.array()).all());
  }
}

// (V11) is the e of (E2) in the form that is linear in H.
TEST_P(ElasticStress, has_the_bending_energy_as_its_isotropic_part) {
  const Example& example = GetParam();
  for (const Direction& d : directions(example.axisymmetric, 6)) {
    const SurfacePoint p = surface_point(example.position(d.n));
    auto x = p.with_order(example.order(d.n));
    const double e = density_at(example, p, x).bending,
                 rounding = 100 * epsilon * (std::abs(e) + 1);
    const Material m = material_of(example);
    EXPECT_NEAR(bending_tension(m, x), e, rounding);
    const double H0 = m.spontaneous_curvature, f = m.flexoelectric.value(x.beta);
    x.H = H0 + 3 * (p.H - H0);
    EXPECT_NEAR(bending_tension(m, x), 3 * (e - f * p.H) + f * x.H, 10 * rounding);
  }
}

TEST_P(ElasticStress, is_the_same_with_numbers_of_another_type) {
  using Jet = ceres::Jet<double, 3>;
  const double rounding = 100 * epsilon;  // all numbers are O(1)
  const Example& example = GetParam();
  for (const Direction& d : directions(example.axisymmetric, 3)) {
    const SurfacePoint p = surface_point(example.position(d.n));
    const auto x = p.with_order(example.order(d.n));
    const ElasticPoint<double, Jet> unknown_curvature{
        x.beta, x.grad_beta, x.B, Jet(x.H, 0), {Jet(x.grad_H[0], 1), Jet(x.grad_H[1], 2)}};
    const Gradient<double> stress = elastic_stress(material_of(example), x);
    const Gradient<Jet> jets = elastic_stress(material_of(example), unknown_curvature);
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 2; ++j) EXPECT_NEAR(jets(i, j).a, stress(i, j), rounding);

    // Linear in H and ∇H: the derivative leads back to the value at H = 0, ∇H = 0.
    auto flat = x;
    flat.H = 0;
    flat.grad_H.setZero();
    const Gradient<double> constant = elastic_stress(material_of(example), flat);
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 2; ++j) {
        const double linear = jets(i, j).v.dot(Eigen::Vector3d(x.H, x.grad_H[0], x.grad_H[1]));
        EXPECT_NEAR(constant(i, j) + linear, stress(i, j), rounding);
      }
  }
}

TEST(EnergyDensity, adds_up_its_parts_which_are_all_in_the_table) {
  EXPECT_EQ(sizeof(Density), parts().size() * sizeof(double));
  const Density density = energy_density(general_material(), 0.4, 0.3, -1.8, 0.7);
  double sum = 0;
  for (const Part& part : parts()) sum += density.*part.density;
  EXPECT_NEAR(density.total(), sum, 4 * epsilon * (std::abs(density.thermotropic) + 1));
}

TEST(EnergyDensity, is_that_of_the_labels) {
  const Material m = general_material();
  const double beta = 0.4, grad_beta_squared = 0.3, H = -1.8, K = 0.7;
  const Density density = energy_density(m, beta, grad_beta_squared, H, K);
  EXPECT_DOUBLE_EQ(density.distortion, m.l1() / 2 * grad_beta_squared);
  EXPECT_DOUBLE_EQ(density.bending,
                   m.kappa(beta) / 2 * (H + 0.7) * (H + 0.7) + m.flexoelectric.value(beta) * H);
  EXPECT_DOUBLE_EQ(density.gaussian, m.kappa_gauss(beta) * K);
  EXPECT_DOUBLE_EQ(density.thermotropic, m.potential.value(beta));
}

TEST(EnergyDensity, of_one_constant_is_distortion_and_the_square_of_the_shape_operator) {
  const double L = 0.03, beta = 0.5, grad_beta_squared = 0.8, k1 = -1.4, k2 = 0.6;
  const Density density =
      energy_density(Material{}.with_L(L), beta, grad_beta_squared, k1 + k2, k1 * k2);
  const double expected =
      0.75 * L * grad_beta_squared + 2.25 * L * beta * beta * (k1 * k1 + k2 * k2);
  EXPECT_NEAR(density.total() - density.thermotropic, expected,
              10 * epsilon * std::abs(density.thermotropic));
}

INSTANTIATE_TEST_SUITE_P(on, ElasticStress, testing::ValuesIn(examples),
                         [](const auto& example) { return std::string(example.param.name); });

}  // namespace
}  // namespace sbeh::model
