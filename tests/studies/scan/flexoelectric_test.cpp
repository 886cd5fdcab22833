// Branches with a flexoelectric coupling f(β)H against what is exact of them.
#include "axisym/stationary/symmetry.h"
#include "studies/scan/branch_points.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

namespace sbeh::studies {
namespace {

using axisym::Branch;
using axisym::StationaryCase;
using model::Model;

StationaryCase case_of(Model model, Branch branch, double v, const std::vector<double>& f) {
  StationaryCase of{.model = model, .branch = branch, .reduced_volume = v};
  of.material = of.material.with_L(0.05);
  of.material.flexoelectric = model::Polynomial(f);
  return of;
}

PointOutcome at_rest(const StationaryCase& of) {
  PointOutcome point = branch_point(of);
  EXPECT_EQ(point.row.status, PointStatus::stationary) << point.row.stop_reason;
  return point;
}

double energy_with(const model::Material& material, const PointOutcome& point) {
  return axisym::energy(material, *point.state, point.state->H).total();
}

// Of a uniform order fH is a spontaneous curvature −f/κ, and ((κ/2)(H₀² − (H₀ − f/κ)²)) A.
TEST(FlexoelectricShape, of_a_uniform_order_is_that_of_a_spontaneous_curvature) {
  for (const Branch branch : {Branch::oblate, Branch::prolate}) {
    StationaryCase of = case_of(Model::SSH, branch, 0.75, {0.05, 0.3, -0.15});
    of.material.spontaneous_curvature = 0.4;
    const double kappa = of.material.kappa(model::full_order);
    StationaryCase with_H0 = of;
    with_H0.material.flexoelectric = model::Polynomial({0});
    with_H0.material.spontaneous_curvature =
        0.4
        - (0.05 + 0.3 * model::full_order - 0.15 * model::full_order * model::full_order) / kappa;
    const PointOutcome a = at_rest(of), b = at_rest(with_H0);
    const double square = with_H0.material.spontaneous_curvature,
                 constant = kappa / 2 * (0.16 - square * square);
    EXPECT_NEAR(energy_with(of.material, a),
                energy_with(with_H0.material, b) + constant * 4 * std::numbers::pi, 1e-9);
    EXPECT_NEAR(a.row.diagnostics->W2, b.row.diagnostics->W2, 1e-7);
    EXPECT_NEAR(a.state->pressure, b.state->pressure, 1e-6);
    EXPECT_NEAR(a.state->tension, b.state->tension - constant, 1e-6);
  }
}

// Of states at rest the energy goes with a number of the material as that of one state does: `with` is the case at a change of
// it, h small.
template <class With>
void expect_slope_by_material(const With& with, double h) {
  const PointOutcome here = at_rest(with(0));
  const double slope = (energy_with(with(h).material, at_rest(with(h)))
                        - energy_with(with(-h).material, at_rest(with(-h))))
                     / (2 * h),
               integral =
                   (energy_with(with(h).material, here) - energy_with(with(-h).material, here))
                   / (2 * h);
  EXPECT_NEAR(slope, integral, 1e-5 * std::abs(integral));
}

// dU/df₁ = ∫βH, which the same state has with two materials.
TEST(FlexoelectricBranch, changes_its_energy_by_the_integral_of_order_times_curvature) {
  constexpr double h = 1e-3;
  for (const Branch branch : {Branch::oblate, Branch::prolate})
    for (const double f1 : {-0.1, 0.1}) {
      const auto with = [&](double change) {
        return case_of(Model::SBEH, branch, 0.8, {0, f1 + change, 0.05});
      };
      SCOPED_TRACE(std::string(name(branch)) + ", f₁ = " + std::to_string(f1));
      expect_slope_by_material(with, h);
    }
}

// κ and κ_G given as those that the elastic constants make are these.
TEST(GivenStiffness, as_the_elastic_constants_have_it_gives_the_same_state) {
  StationaryCase of = case_of(Model::SBEH, Branch::oblate, 0.8, {0});
  const PointOutcome by_L = at_rest(of);
  of.material.kappa_powers = model::Polynomial({0, 0, 4.5 * 0.05});
  of.material.kappa_gauss_powers = model::Polynomial({0, 0, -4.5 * 0.05});
  const PointOutcome given = at_rest(of);
  EXPECT_NEAR(energy_with(of.material, given), energy_with(of.material.with_L(0.05), by_L), 1e-9);
  EXPECT_NEAR(given.row.diagnostics->W2, by_L.row.diagnostics->W2, 1e-7);
}

TEST(GivenStiffness, changes_the_energy_by_its_own_integral) {
  constexpr double h = 1e-4;
  const auto with = [](double change) {
    StationaryCase of = case_of(Model::SBEH, Branch::oblate, 0.8, {0});
    of.material.kappa_powers = model::Polynomial({0.02, 0.1, 0.1 + change});
    of.material.kappa_gauss_powers = model::Polynomial({0, -0.05, -0.1});
    return of;
  };
  expect_slope_by_material(with, h);
}

// L₂ and L₃ go along with L on the way from SSH's shape.
TEST(UnequalModuli, change_the_energy_by_their_own_integrals) {
  for (const Branch branch : {Branch::oblate, Branch::prolate})
    for (double model::Material::*const constant : {&model::Material::L2, &model::Material::L3}) {
      const auto with = [&](double change) {
        StationaryCase of = case_of(Model::SBEH, branch, 0.8, {0});
        of.material.L2 = 0.02;
        of.material.L3 = -0.01;
        of.material.*constant += change;
        return of;
      };
      expect_slope_by_material(with, 1e-3);
    }
}

TEST(UnequalModuli, are_the_same_from_the_side_and_from_the_beginning) {
  const auto at = [](double L) {
    StationaryCase of = case_of(Model::SBEH, Branch::oblate, 0.8, {0});
    of.material.L2 = 0.03;
    of.material.L3 = 0.01;
    of.material.L1 = L;
    return of;
  };
  const PointOutcome first = at_rest(at(0.02)), direct = at_rest(at(0.04));
  const PointOutcome along = follow_to(at(0.04), {at(0.02).at(), *first.state});
  EXPECT_NEAR(energy_with(at(0.04).material, along), energy_with(at(0.04).material, direct), 1e-9);
}

// On the way from SSH's shapes nothing of the symmetry is lost, by which lines of stability are told apart.
TEST(UnequalModuli, leave_oblates_symmetric) {
  for (const double L2 : {-0.02, 0.02}) {
    StationaryCase of = case_of(Model::SBEH, Branch::oblate, 0.7, {0});
    of.material.L2 = L2;
    EXPECT_TRUE(axisym::is_symmetric(at_rest(of).state->X)) << L2;
    of.material.L2 = 0;
    of.material.flexoelectric = model::Polynomial({0, L2});
    EXPECT_TRUE(axisym::is_symmetric(at_rest(of).state->X)) << L2;
  }
}

// ∂U/∂W₂⁰ = −c of SSH and SBEH; a couple has c from another shape of the same W₂.
TEST(AreaDifferenceBranch, changes_its_energy_by_the_moment) {
  for (const Model model : {Model::SBEH, Model::SSH})
    for (const Branch branch : {Branch::oblate, Branch::prolate}) {
      const auto with = [&](double change) {
        StationaryCase of = case_of(model, branch, 0.8, {0});
        of.material.area_difference = {0.14, -8 * std::numbers::pi * 1.05 + change};
        return of;
      };
      SCOPED_TRACE(std::string(name(model)) + " " + name(branch));
      const PointOutcome here = at_rest(with(0));
      EXPECT_GT(here.row.diagnostics->energy.area_difference, 1e-5);
      constexpr double h = 1e-2;
      const double slope = (energy_with(with(h).material, at_rest(with(h)))
                            - energy_with(with(-h).material, at_rest(with(-h))))
                         / (2 * h);
      EXPECT_NEAR(slope, -here.state->moment, 1e-5);
    }
}

TEST(AreaDifferenceBranch, has_the_shapes_of_a_spontaneous_curvature) {
  StationaryCase of = case_of(Model::SSH, Branch::oblate, 0.7, {0});
  of.material.area_difference = {0.2, -28};
  const PointOutcome strained = at_rest(of);
  StationaryCase curved = case_of(Model::SSH, Branch::oblate, 0.7, {0});
  curved.material.spontaneous_curvature =
      -strained.state->moment / of.material.kappa(model::full_order);
  const PointOutcome same = at_rest(curved);
  EXPECT_GT(std::abs(strained.state->moment), 1e-3);
  EXPECT_NEAR(strained.row.diagnostics->W2, same.row.diagnostics->W2, 1e-6);
  EXPECT_NEAR(strained.row.diagnostics->H_pole, same.row.diagnostics->H_pole, 1e-6);
}

// Whatever the way: from SSH's shape at this L, or from a state at another L with the same f.
TEST(FlexoelectricBranch, is_the_same_from_the_side_and_from_its_beginning) {
  const auto at = [](double L) {
    StationaryCase of = case_of(Model::SBEH, Branch::oblate, 0.8, {0, 0.1});
    of.material = of.material.with_L(L);
    return of;
  };
  const PointOutcome first = at_rest(at(0.03)), direct = at_rest(at(0.05));
  const PointOutcome along = follow_to(at(0.05), {at(0.03).at(), *first.state});
  EXPECT_EQ(along.row.status, PointStatus::stationary) << along.row.stop_reason;
  EXPECT_NEAR(energy_with(at(0.05).material, along), energy_with(at(0.05).material, direct), 1e-9);
}

}  // namespace
}  // namespace sbeh::studies
