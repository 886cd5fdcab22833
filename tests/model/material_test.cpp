// The moduli, the potential and the rest order of the material.
#include "model/material.h"

#include "model/order_step.h"
#include "model/potential.h"
#include "model/terms.h"
#include "tests/model/general_material.h"

#include <ceres/jet.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace sbeh::model {
namespace {

using test::general_material;

using Jet = ceres::Jet<double, 1>;
constexpr double epsilon = std::numeric_limits<double>::epsilon();
const auto orders = {0.0, 0.2, 0.5, full_order};

TEST(Material, has_the_moduli_of_three_elastic_constants) {
  Material m;
  m.L1 = 0.7;
  m.L2 = -0.2;
  m.L3 = 0.4;
  m.residual_stiffness = 0.3;
  EXPECT_DOUBLE_EQ(m.l1(), (6 * 0.7 - 0.2 + 0.4) / 4);
  for (const double beta : orders) {
    EXPECT_DOUBLE_EQ(m.kappa(beta), 9. / 4 * beta * beta * (2 * 0.7 - 0.2 + 0.4) + 0.3);
    EXPECT_DOUBLE_EQ(m.kappa_gauss(beta), -9. / 4 * beta * beta * (2 * 0.7 + 0.4));
  }
}

TEST(Material, has_the_moduli_of_the_one_constant_approximation) {
  const double L = 0.03;
  Material general = general_material();
  general.residual_stiffness = 0;
  const Material m = general.with_L(L);
  EXPECT_EQ(m.L1, L);
  EXPECT_EQ(m.L2, 0);
  EXPECT_EQ(m.L3, 0);
  EXPECT_EQ(m.potential, general.potential) << "the rest is as it was";
  EXPECT_EQ(m.spontaneous_curvature, general.spontaneous_curvature);
  EXPECT_DOUBLE_EQ(m.l1(), 1.5 * L);
  for (const double beta : orders) {
    EXPECT_DOUBLE_EQ(m.kappa(beta), 4.5 * L * beta * beta);
    EXPECT_DOUBLE_EQ(m.kappa_gauss(beta), -4.5 * L * beta * beta);
  }
  EXPECT_DOUBLE_EQ(m.kappa(full_order), 2 * L);
}

TEST(Material, has_the_slopes_of_its_moduli) {
  const Material m = general_material();
  for (const double beta : orders) {
    EXPECT_NEAR(m.kappa_slope(beta), m.kappa(Jet(beta, 0)).v[0], 4 * epsilon);
    EXPECT_NEAR(m.kappa_gauss_slope(beta), m.kappa_gauss(Jet(beta, 0)).v[0], 4 * epsilon);
  }
}

TEST(Material, has_a_viscosity_and_a_drag_that_depend_on_the_coupling) {
  Material m;
  m.viscosity = 2;
  m.immobility = 3;
  EXPECT_DOUBLE_EQ(m.eta(0.5), 2);
  EXPECT_DOUBLE_EQ(m.order_drag(), 4.5);
  m.order_viscosity = 0.8;
  EXPECT_DOUBLE_EQ(m.eta(0.5), 2 * 1.2 * 1.2);
  EXPECT_DOUBLE_EQ(m.order_drag(), 1.5 * (3 + 0.64));
}

TEST(Material, is_by_default_that_of_the_paper) {
  const Material m;
  EXPECT_EQ(m.potential, Potential::landau_de_gennes(0, -27, 13.5));
  EXPECT_EQ(m.viscosity, 1);
  EXPECT_EQ(m.immobility, 1);
  EXPECT_EQ(m.friction_tangential, 0.1);
  EXPECT_EQ(m.friction_normal, 0.1);
  EXPECT_EQ(m.order_viscosity, 0);
  EXPECT_EQ(m.residual_stiffness, 0);
  EXPECT_EQ(m.spontaneous_curvature, 0);
  EXPECT_NO_THROW(m.validate());
}

TEST(Model, has_a_name) {
  EXPECT_STREQ(name(Model::SBEH), "SBEH");
  EXPECT_STREQ(name(Model::SSH), "SSH");
  EXPECT_STREQ(name(Model::HelfrichLocal), "Helfrich-local");
  EXPECT_STREQ(name(Model::HelfrichGlobal), "Helfrich-global");
}

TEST(Model, of_the_Helfrich_flows_has_its_own_drag_and_the_rest_states_of_SSH) {
  const Material m = general_material();
  for (const Model model : {Model::SBEH, Model::SSH}) {
    const Material same = effective(m, model);
    EXPECT_FALSE(has_own_drag(model));
    EXPECT_EQ(rest_model(model), model);
    EXPECT_EQ(area_constraint(model), AreaConstraint::local);
    EXPECT_EQ(same.viscosity, m.viscosity);
    EXPECT_EQ(same.friction_tangential, m.friction_tangential);
    EXPECT_EQ(same.friction_normal, m.friction_normal);
  }
  for (const Model model : {Model::HelfrichLocal, Model::HelfrichGlobal}) {
    const Material own = effective(m, model);
    EXPECT_TRUE(has_own_drag(model));
    EXPECT_FALSE(has_free_order(model));
    EXPECT_EQ(rest_model(model), Model::SSH);
    EXPECT_EQ(own.eta(full_order), 0);
    EXPECT_EQ(own.friction_normal, 1);
    EXPECT_EQ(own.kappa(full_order), m.kappa(full_order)) << "the energy is that of the material";
    EXPECT_EQ(own.spontaneous_curvature, m.spontaneous_curvature);
  }
  EXPECT_EQ(effective(m, Model::HelfrichLocal).friction_tangential, 1);
  EXPECT_EQ(effective(m, Model::HelfrichGlobal).friction_tangential, 0);
}

TEST(Potential, of_Landau_and_de_Gennes_has_its_printed_form) {
  const double a = 0.3, b = -2, c = 1.7;
  const Potential u = Potential::landau_de_gennes(a, b, c);
  for (const double beta : {-0.4, 0.0, 0.3, 0.9}) {
    EXPECT_NEAR(u.value(beta), beta * beta / 8 * (12 * a + 4 * b * beta + 9 * c * beta * beta),
                10 * epsilon);
    EXPECT_NEAR(u.secant(beta), 1.5 * (2 * a + b * beta + 3 * c * beta * beta), 20 * epsilon);
  }
  EXPECT_EQ(u.slope_at_zero(), 0);
}

TEST(Potential, of_the_paper_has_its_minimum_minus_one_at_full_order) {
  const Potential u;
  const double rounding = 100 * epsilon;  // terms up to 60
  EXPECT_NEAR(u.value(full_order), -1, rounding);
  EXPECT_NEAR(u.slope(full_order), 0, rounding);
  EXPECT_NEAR(u.slope(Jet(full_order, 0)).v[0], 27, rounding);
  EXPECT_EQ(u.value(0.), 0);
  EXPECT_EQ(u.slope(0.), 0) << "the disordered state is stationary";
}

TEST(Potential, has_the_slope_and_secant_of_its_polynomial) {
  const Potential u = general_material().potential;  // degree 6, with a linear term
  ASSERT_EQ(u.coefficients().size(), 7u);
  const double rounding = 100 * epsilon;
  EXPECT_EQ(u.slope_at_zero(), u.coefficients()[1]);
  EXPECT_EQ(u.slope(0.), u.slope_at_zero());
  EXPECT_EQ(u.secant(0.), u.slope(Jet(0, 0)).v[0]);
  for (const double beta : {-0.6, 0.1, 0.45, 0.8, 1.3}) {
    double value = 0;
    for (std::size_t k = 0; k < 7; ++k) value += u.coefficients()[k] * std::pow(beta, double(k));
    EXPECT_NEAR(u.value(beta), value, rounding);
    EXPECT_NEAR(u.slope(beta), u.value(Jet(beta, 0)).v[0], rounding);
    EXPECT_NEAR(u.secant(beta), (u.slope(beta) - u.slope_at_zero()) / beta, 10 * rounding);
  }
}

TEST(Potential, may_be_of_low_degree_or_empty) {
  for (const Potential& u : {Potential(std::vector<double>{}), Potential(std::vector<double>{3}),
                             Potential(std::vector<double>{3, -2})}) {
    EXPECT_EQ(u.slope(0.7), u.coefficients().size() > 1 ? -2 : 0);
    EXPECT_EQ(u.secant(0.7), 0);
  }
}

TEST(RestOrder, of_the_paper_is_the_larger_root_of_a_quadratic) {
  Material m;
  for (const double L : {0.01, 0.05, 0.3, 0.7}) {
    const auto beta = sphere_rest_order(m.with_L(L));
    ASSERT_TRUE(beta.has_value()) << L;
    EXPECT_NEAR(*beta, (40.5 + std::sqrt(40.5 * 40.5 - 4 * 60.75 * 9 * L)) / (2 * 60.75),
                100 * epsilon);
  }
  EXPECT_NEAR(*sphere_rest_order(m.with_L(0.05)), 0.655364, 5e-7);
  EXPECT_FALSE(sphere_rest_order(m.with_L(0.76)).has_value())
      << "above 0.75 disorder alone is left";
}

TEST(RestOrder, is_stationary_and_stable_for_a_general_material) {
  Material m = general_material();
  m.potential = Potential({0, 0.4, -14, 3, 16, 0, 2});
  const auto beta = sphere_rest_order(m);
  ASSERT_TRUE(beta.has_value());
  const Jet force = order_force(m, Jet(*beta, 0), Jet(-2), Jet(1));
  EXPECT_NEAR(force.a, 0, 100 * epsilon * force.v[0]);
  EXPECT_GT(force.v[0], 0);
}

}  // namespace
}  // namespace sbeh::model
