// Rates of small perturbations: closed forms on the sphere, rigid motions, the flow of the time stepping.
#include "axisym/modes/growth_rates.h"

#include "axisym/modes/eigenmodes.h"
#include "axisym/stationary/continuation.h"
#include "axisym/stationary/ssh_branch.h"
#include "model/numerics/root.h"
#include "model/order_step.h"
#include "tests/axisym/cases.h"
#include "tests/axisym/modes/states.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <map>

namespace sbeh::axisym {
namespace {

using namespace test;
using model::Material;
using model::Model;

// What resists v along the normal and β̇, both with the harmonic l: along the surface goes a gradient with
// Div_C V = (a'/a)β̇.
Eigen::Matrix2d sphere_resistance(const Material& m, double order, double n) {
  const auto resistance = [&](double v, double beta_dot) {
    const double spread = -2 * v + m.expansion(order) * beta_dot;  // of the tangential part
    const double along = spread * spread / n;
    return m.friction_normal * v * v + m.friction_tangential * along
         + 2 * m.eta(order) * (spread * spread - along + 2 * v * spread + 2 * v * v)
         + m.order_drag(order) * beta_dot * beta_dot;
  };
  const double both = (resistance(1, 1) - resistance(1, -1)) / 4;
  return Eigen::Matrix2d{{resistance(1, 0), both}, {both, resistance(0, 1)}};
}

// The rates of the harmonic l on a sphere under a tension: of shape and order together, where both are free.
std::vector<double> sphere_rates(const Material& m, Model model, double order, double tension,
                                 int l) {
  const double n = l * (l + 1), bend = n - 2;
  const double bending = bend * (m.kappa(order) * n + tension);
  const Eigen::Matrix2d resistance = sphere_resistance(m, order, n);
  if (!has_free_order(model))
    return l < 2 ? std::vector<double>{} : std::vector{-bending / resistance(0, 0)};
  const double curvature = (182.25 * order - 81) * order;                     // u″
  const double stiffening = 2 * m.kappa_slope(1.) + m.kappa_gauss_slope(1.);  // κ″H²/2 + κ_G″K
  const double ordering = m.l1() * n + stiffening + curvature;
  if (l == 0) {  // the size does not change
    if (m.has_lipid_density()) return {};
    return {-ordering / m.order_drag()};
  }
  if (l == 1 && !m.has_lipid_density()) return {-ordering / m.order_drag()};
  const double coupling = (2 * m.kappa_slope(order) + m.kappa_gauss_slope(order)) * bend;
  const Eigen::Matrix2d form{{bending, coupling}, {coupling, ordering}};
  const Eigen::Vector2d lambda =
      Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::Matrix2d>(form, resistance).eigenvalues();
  if (l == 1) return {-lambda[1]};  // the other one moves the whole
  return {-lambda[0], -lambda[1]};
}

// The order that rests there.
double resting_order(const Material& m, double tension) {
  if (!m.has_lipid_density()) return model::sphere_rest_order(m).value();
  const auto force = [&](double beta) {
    const double Sigma = (tension - m.potential.value(beta)) / m.packing(beta);
    return model::order_force(m, beta, -2., 1.) + Sigma * m.packing_slope(beta);
  };
  return model::root_between(force, 0.5, 0.9).middle();
}

// The two largest rates of each m and parity, against those of all harmonics with it.
void expect_sphere_rates(const Material& material, Model model, double accuracy) {
  const double tension = 0.07;
  const double order = has_free_order(model) ? resting_order(material, tension) : model::full_order;
  const auto second =
      second_variation(material, model, sphere_at_rest(material, model, order, tension, 96));
  for (int m = 0; m <= 4; ++m) {
    SCOPED_TRACE(m);
    const auto found = growth_rates({second, material, model}, m, 2);
    ASSERT_TRUE(found);
    for (const Parity parity : {Parity::even, Parity::odd}) {
      std::vector<double> exact;
      for (int l = m; l < 12; ++l)
        if ((l - m) % 2 == (parity == Parity::odd))
          std::ranges::copy(sphere_rates(material, model, order, tension, l),
                            std::back_inserter(exact));
      std::ranges::sort(exact, std::greater{});
      std::size_t k = 0;
      for (const GrowthMode& mode : *found) {
        if (mode.parity != parity) continue;
        EXPECT_NEAR(mode.rate / exact[k++], 1, accuracy);
      }
      EXPECT_EQ(k, 2U);
    }
  }
}

TEST(GrowthRates, of_the_sphere_are_those_of_the_harmonics) {
  struct Drag {
    double viscosity, tangential, normal, order_viscosity;
  };
  for (const Drag& drag : {Drag{1, 0.1, 0.1, 0},
                           {1, 0.1, 0.1, 0.5},
                           {0, 1, 1, 0},
                           {1, 0, 0, 0},
                           {1, 0, 0.3, 0},
                           {0.001, 0.1, 0.2, -1}}) {
    SCOPED_TRACE(drag.viscosity);
    Material material;
    material.viscosity = drag.viscosity;
    material.friction_tangential = drag.tangential;
    material.friction_normal = drag.normal;
    material.order_viscosity = drag.order_viscosity;
    expect_sphere_rates(material, Model::SSH, 1e-8);
    expect_sphere_rates(material, Model::SBEH, 1e-8);
  }
}

// Rigid motions are part of the modes of m = 0 and 1, which friction resists; the equator may cut an element.
TEST(GrowthRates, of_48_elements_are_good_to_1e_6_where_motions_are_in_them) {
  const auto rates = [](int elements, int m) {
    const auto state = ssh_oblate(0.7, elements);
    const auto second = second_variation({}, Model::SSH, state.value());
    std::map<Parity, double> largest;
    const auto modes = growth_rates({second, {}, Model::SSH}, m, 1);
    for (const GrowthMode& mode : modes.value()) largest[mode.parity] = mode.rate;
    return largest;
  };
  for (const int m : {0, 1}) {
    const auto exact = rates(192, m);
    for (const int elements : {48, 49})
      for (const auto& [parity, rate] : rates(elements, m))
        EXPECT_NEAR(rate / exact.at(parity), 1, 1e-6) << m << ' ' << elements;
    for (const auto& [parity, rate] : rates(96, m))
      EXPECT_NEAR(rate / exact.at(parity), 1, 2e-8) << m;
  }
}

TEST(GrowthRates, of_the_sphere_know_unequal_moduli) {
  Material material;
  material.L2 = 0.02;
  material.L3 = 0.03;
  expect_sphere_rates(material, Model::SSH, 1e-8);
  expect_sphere_rates(material, Model::SBEH, 1e-8);
}

TEST(GrowthRates, of_the_sphere_know_the_area_per_lipid) {
  Material material;
  material.lipid_density = model::Polynomial({1 / 1.3, 1.5 * (1 - 1 / 1.3)});
  expect_sphere_rates(material, Model::SBEH, 1e-8);
  material.order_viscosity = -0.5;
  material.friction_tangential = 0.4;
  expect_sphere_rates(material, Model::SBEH, 1e-8);
}

TEST(GrowthRates, of_the_L2_flow_along_the_normals_are_the_eigenvalues) {
  const Material material;
  SshBranch branch(Branch::oblate, material, Numerics{});
  const auto state = branch.at(0.7);
  ASSERT_TRUE(state && state->arrival == Arrival::reached);
  const auto second = second_variation(material, Model::SSH, state->state);
  for (int m = 0; m <= 3; ++m) {
    const auto rates = growth_rates({second, material, Model::HelfrichGlobal}, m, 1);
    const auto modes = lowest_modes(second, m, 1);
    ASSERT_TRUE(rates && modes);
    ASSERT_EQ(rates->size(), modes->modes.size());
    for (std::size_t k = 0; k < modes->modes.size(); ++k)
      EXPECT_EQ((*rates)[k].rate, -modes->modes[k].eigenvalue);
  }
}

// Rates and eigenvalues have opposite signs, and there are as many of either.
TEST(GrowthRates, have_the_inertia_of_the_second_variation) {
  const auto state = ordered_oblate(0.6, 0.07, 48);
  ASSERT_TRUE(state);
  const Material material = Material{}.with_L(0.07);
  const auto second = second_variation(material, Model::SBEH, *state);
  int growing = 0;
  for (int m = 0; m <= 4; ++m) {
    const auto rates = growth_rates({second, material, Model::SBEH}, m, 3);
    const auto modes = lowest_modes(second, m, 3);
    ASSERT_TRUE(rates && modes);
    const auto positive =
        std::ranges::count_if(*rates, [](const GrowthMode& mode) { return mode.rate > 0; });
    EXPECT_EQ(positive,
              std::ranges::count_if(modes->modes,
                                    [](const Eigenmode& mode) { return mode.eigenvalue < 0; }))
        << m;
    growing += int(positive);
  }
  EXPECT_EQ(growing, 2);  // m = 1 and m = 2, each with cos and sin
}

// Where nothing resists motions as a whole the rates are the limit of small friction.
TEST(GrowthRates, without_friction_are_those_of_little_friction) {
  const auto state = ordered_oblate(0.7, 0.04, 48);
  ASSERT_TRUE(state);
  const auto rate = [&](double friction, int m) {
    Material material = Material{}.with_L(0.04);
    material.friction_tangential = material.friction_normal = friction;
    const auto second = second_variation(material, Model::SBEH, *state);
    const auto found = growth_rates({second, material, Model::SBEH}, m, 1);
    return found ? found->front().rate : std::nan("");
  };
  for (int m = 0; m <= 3; ++m) {
    const double none = rate(0, m);
    EXPECT_NEAR(rate(1e-6, m) / none, 1, 1e-5) << m;
    EXPECT_NEAR((rate(2e-4, m) - none) / (rate(1e-4, m) - none), 2, 1e-2) << m;
  }
}

}  // namespace
}  // namespace sbeh::axisym
