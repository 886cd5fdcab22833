// [material] and [numerics]: what is read, and what is refused with which words.
#include "studies/parameters/material_input.h"

#include "studies/compare/compare_input.h"
#include "studies/evolution/relax_input.h"
#include "studies/scan/scan_input.h"
#include "tests/studies/parameters/input_file.h"

#include <limits>
#include <numbers>

namespace sbeh::studies {
namespace {

using namespace test;

model::Material material_of(const std::string& table) {
  return read_relax(written(small_relax + "[material]\n" + table)).material;
}

TEST(Material, has_shorthands_for_elastic_constants_friction_and_potential) {
  const model::Material material =
      material_of("L = 0.03\nfriction = 0\nlandau_de_gennes = { a = 1, b = 2, c = 4 }\n");
  EXPECT_EQ(material.L1, 0.03);
  EXPECT_EQ(material.L2, 0);
  EXPECT_EQ(material.friction_tangential, 0);
  EXPECT_EQ(material.friction_normal, 0);
  EXPECT_EQ(material.potential, model::Potential::landau_de_gennes(1, 2, 4));
}

TEST(Material, takes_every_parameter_of_its_own) {
  const model::Material material = material_of(
      "L1 = 0.02\nL2 = 0.01\nL3 = -0.005\nviscosity = 2\nimmobility = 3\n"
      "friction_tangential = 0.2\nfriction_normal = 0.3\norder_viscosity = -0.5\n"
      "residual_stiffness = 0.01\nspontaneous_curvature = -1\nflexoelectric = [0.1, -2]\n"
      "lipid_density = [1, 0.5]\n"
      "potential = [1, 0, -3, 0, 2, 0]\n");
  model::Material expected{
      .L1 = 0.02,
      .L2 = 0.01,
      .L3 = -0.005,
      .potential = model::Potential({1, 0, -3, 0, 2, 0}),
      .viscosity = 2,
      .immobility = 3,
      .friction_tangential = 0.2,
      .friction_normal = 0.3,
      .order_viscosity = -0.5,
      .residual_stiffness = 0.01,
      .spontaneous_curvature = -1,
      .flexoelectric = model::Polynomial({0.1, -2}),
      .lipid_density = model::Polynomial({1, 0.5}),
  };
  EXPECT_EQ(material, expected);
}

TEST(Material, has_an_area_difference_by_W2_or_by_areas) {
  const double a0 = -8 * std::numbers::pi;
  EXPECT_EQ(material_of("area_difference = { stiffness = 0.14, W2 = -26.5 }\n").area_difference,
            (model::AreaDifference{0.14, -26.5}));
  EXPECT_EQ(material_of("area_difference = { stiffness = inf, delta_a0 = 1.1 }\n").area_difference,
            (model::AreaDifference{std::numeric_limits<double>::infinity(), 1.1 * a0}));
  expect_messages(read_relax, small_relax + "[material]\n",
                  {{"area_difference = { stiffness = 0, W2 = -26 }",
                    ":5: [material] area_difference.stiffness = 0: must be > 0"},
                   {"area_difference = { stiffness = 1, W2 = -26, delta_a0 = 1 }",
                    ":5: [material] area_difference.W2 = -26: must not be given together with "
                    "delta_a0, which is −W2/8π"},
                   {"area_difference = { stiffness = 1 }",
                    ":5: [material] area_difference.W2: missing; must be a number"}});
}

TEST(Material, may_have_any_potential_that_is_bounded_below) {
  for (const char* bounded : {"[0]", "[3]", "[3, 0, 0]", "[0, 5, 1]", "[0, 0, -1, 0, 0.1]"})
    EXPECT_EQ(message_for(read_scan, written(small_scan + "[material]\npotential = " + bounded)),
              "accepted")
        << bounded;
}

TEST(Material, that_is_wrong_is_refused_with_line_key_and_value) {
  const std::string bounded =
      ": must be bounded below: its highest power even, with a coefficient > 0";
  const std::string in_scan = ": must not be given in a scan, where L comes from [scan]";
  const std::vector<Case> in_scans{
      {"L = 0.1", ":5: [material] L = 0.1" + in_scan},
      {"L1 = 0", ":5: [material] L1 = 0" + in_scan},
      {"viscosity = -1", ":5: [material] viscosity = -1: must be >= 0"},
      {"viscosity = 'a'", ":5: [material] viscosity = 'a': must be a number"},
      {"immobility = 0", ":5: [material] immobility = 0: must be > 0"},
      {"order_viscosity = nan", ":5: [material] order_viscosity = nan: must be a finite number"},
      {"residual_stiffness = -0.1", ":5: [material] residual_stiffness = -0.1: must be >= 0"},
      {"friction = -1", ":5: [material] friction = -1: must be >= 0"},
      {"friction_normal = -1", ":5: [material] friction_normal = -1: must be >= 0"},
      {"friction = 1\nfriction_normal = 0",
       ":6: [material] friction_normal = 0: must not be given together with friction, which sets "
       "both"},
      {"\nviscosity = 0\nfriction = 0",
       ":4: [material] viscosity + friction_tangential = 0: must be > 0 (else nothing resists the "
       "flow)"},
      {"potential = 3", ":5: [material] potential = 3: must be a list of numbers"},
      {"potential = []", ":5: [material] potential = []: must not be empty"},
      {"potential = [1, inf]", ":5: [material] potential = inf: must be a finite number"},
      {"potential = [0, 1]", ":5: [material] potential = [0, 1]" + bounded},
      {"potential = [0, 0, 1, 2, 0]", ":5: [material] potential = [0, 0, 1, 2, 0]" + bounded},
      {"potential = [0, 0, -1]", ":5: [material] potential = [0, 0, -1]" + bounded},
      {"potential = [1]\nlandau_de_gennes = 3",
       ":6: [material] landau_de_gennes = 3: must not be given together with potential"},
      {"landau_de_gennes = 3", ":5: [material] landau_de_gennes = 3: must be a table"},
      {"landau_de_gennes = { a = 1, b = 2 }",
       ":5: [material] landau_de_gennes.c: missing; must be a number"},
      {"landau_de_gennes = { a = 1, b = 2, c = 3, d = 4 }",
       ":5: [material] landau_de_gennes.d: unknown key. Known: a, b, c"},
      {"landau_de_gennes = { a = 1, b = 0, c = -1 }",
       ":5: [material] landau_de_gennes = { a = 1, b = 0, c = -1 }" + bounded},
      {"landau_de_gennes = { a = 1.5e308, b = 0, c = 1 }",
       ":5: [material] landau_de_gennes = { a = 1.5e+308, b = 0, c = 1 }: coefficients must be "
       "smaller"},
      {"viscocity = 1",
       ":5: [material] viscocity: unknown key; did you mean 'viscosity'? Known: L2, L3, friction, "
       "potential, landau_de_gennes, viscosity, immobility, friction_tangential, friction_normal, "
       "order_viscosity, residual_stiffness, spontaneous_curvature, kappa, kappa_gauss, "
       "flexoelectric, lipid_density, area_difference, order, mean_order, order_mobility"},
  };
  expect_messages(read_scan, small_scan + "[material]\n", in_scans);
  const std::vector<Case> in_evolutions{
      {"L = 0.1\nL2 = 0",
       ":6: [material] L2 = 0: must not be given together with L, which means L1 = L, L2 = L3 = 0"},
      {"L = -1", ":5: [material] L = -1: must be > 0"},
      {"L1 = -1", ":4: [material] 6 L1 + L2 + L3 = -6: must be > 0 (distortion energy)"},
      {"L1 = 0.25\nL2 = -1", ":4: [material] 2 L1 + L2 + L3 = -0.5: must be >= 0 (bending energy)"},
  };
  expect_messages(read_relax, small_relax + "[material]\n", in_evolutions);
}

TEST(Material, that_a_method_does_not_know_is_refused) {
  const std::string rims =
      "[scan]\nreduced_volume = 0.7\nL = 0.05\nbeyond_fold = true\n[material]\n";
  expect_messages(
      read_scan, rims,
      {{"area_difference = { stiffness = 1, W2 = -26 }",
        ":6: [material] area_difference = { W2 = -26, stiffness = 1 }: must not be given with "
        "beyond_fold: sharp rims are known "
        "without it"},
       {"order = 'conserved'\nmean_order = 0.6",
        ":6: [material] order = 'conserved': must be 'relaxing' with beyond_fold: sharp rims are "
        "known with it"}});
  expect_messages(read_compare,
                  "[compare]\nmodel = 'SBEH'\nL = 0.05\nreduced_volume = 0.8\nmethods = ['newton', "
                  "'minimiser']\n[material]\n",
                  {{"order = 'conserved'\nmean_order = 0.6",
                    ":7: [material] order = 'conserved': must be 'relaxing' in a comparison: most "
                    "methods know no other"}});
}

TEST(Material, may_have_an_order_that_is_conserved) {
  const model::Material material =
      material_of("order = 'diffusive'\nmean_order = 0.6\norder_mobility = 2\n");
  EXPECT_EQ(material.order, model::OrderDynamics::diffusive);
  EXPECT_EQ(material.mean_order, 0.6);
  EXPECT_EQ(material.order_mobility, 2);
  expect_messages(
      read_relax, small_relax + "[material]\n",
      {{"order = 'kept'",
        ":5: [material] order = 'kept': must be one of 'relaxing', 'conserved', 'diffusive'"},
       {"order = 'conserved'",
        ":5: [material] order = 'conserved': needs mean_order, the (1/A)∫β dS that stays"},
       {"order = 'conserved'\nmean_order = 0.6\norder_mobility = 2",
        ":7: [material] order_mobility = 2: has a meaning with order = 'diffusive' only"}});
}

TEST(Numerics, that_are_wrong_are_refused_with_line_key_and_value) {
  const std::vector<Case> numerics{
      {"elements = 7", ":5: [numerics] elements = 7: must be in 8 ... 4096"},
      {"elements = 64.0", ":5: [numerics] elements = 64.0: must be an integer"},
      {"elements = 99999999999",
       ":5: [numerics] elements = 99999999999: must be >= -2147483647 and <= 2147483647"},
      {"\ngrading = 5", ":6: [numerics] grading = 5: must be in 0 ... 4"},
      {"tolerance = 0", ":5: [numerics] tolerance = 0: must be in 1e-12 ... 0.1"},
      {"first_step = 1",
       ":4: [numerics] largest_step = 0.05: must be >= first_step and smallest_step"},
      {"extrapolate = 1", ":5: [numerics] extrapolate = 1: must be true or false"},
      {"elemnts = 32",
       ":5: [numerics] elemnts: unknown key; did you mean 'elements'? Known: elements, grading, "
       "tolerance, first_step, smallest_step, largest_step, extrapolate, rest_speed"},
  };
  expect_messages(read_scan, small_scan + "[numerics]\n", numerics);
}

}  // namespace
}  // namespace sbeh::studies
