// Rows of SSH: the same whatever else a scan asks for, known to what their error columns say, followed to a
// spontaneous curvature, and told as limits where necks close.

#include "axisym/shape_class.h"
#include "axisym/stationary/limit_shape.h"
#include "studies/scan/branch_points.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace sbeh::studies {
namespace {

using axisym::Branch;
using axisym::SshBranch;
using axisym::StationaryCase;
using model::Model;

StationaryCase case_of(Branch branch, double v, double H0 = 0, int elements = 48) {
  StationaryCase of{.model = Model::SSH, .branch = branch, .reduced_volume = v};
  of.material.spontaneous_curvature = H0;
  of.numerics.elements = elements;
  return of;
}

PointOutcome alone(const StationaryCase& of) {
  SshBranch branch(of.branch, of.material, of.numerics);
  return ssh_point(of, branch);
}

double energy_of(const PointOutcome& point) { return point.row.diagnostics->energy.total(); }

TEST(RowOfAScan, has_the_same_bits_alone_and_after_others) {
  for (const auto& [branch, others, v] :
       {std::tuple{Branch::stomatocyte, std::vector{0.64, 0.42}, 0.4},
        {Branch::prolate, std::vector{0.93, 0.51, 0.31}, 0.3},
        {Branch::oblate, std::vector{0.505, 0.45}, 0.3}}) {
    SCOPED_TRACE(name(branch));
    const StationaryCase of = case_of(branch, v);
    SshBranch shared(branch, of.material, of.numerics);
    for (const double other : others) ssh_point(case_of(branch, other), shared);
    const PointOutcome after = ssh_point(of, shared), lone = alone(of);
    ASSERT_TRUE(after.state && lone.state);
    EXPECT_EQ(energy_of(after), energy_of(lone));
    EXPECT_EQ(after.row.stop_reason, lone.row.stop_reason);
  }
}

TEST(SymmetricBranches, pass_where_others_leave_them_and_say_what_is) {
  const PointOutcome point = alone(case_of(Branch::oblate, 0.3));
  EXPECT_EQ(point.row.status, PointStatus::unresolved);
  EXPECT_TRUE(point.row.self_contact) << point.row.stop_reason;
  EXPECT_NEAR(energy_of(point), -6.857131672, 1e-8);
}

TEST(LongTubes, are_resolved) {
  const PointOutcome point = alone(case_of(Branch::prolate, 0.13));
  EXPECT_EQ(point.row.status, PointStatus::stationary) << point.row.stop_reason;
}

TEST(LongTubes, of_SSH_keep_their_order_to_the_bit) {
  const PointOutcome point = alone(case_of(Branch::prolate, 0.35));
  ASSERT_TRUE(point.state);
  EXPECT_TRUE((point.state->beta.array() == model::full_order).all());
}

// Of shapes that few elements resolve badly: thin necks and long tubes.
TEST(ErrorColumns, bound_the_errors_whatever_the_elements) {
  for (const auto& [branch, v, H0] : {std::tuple{Branch::stomatocyte, 0.4, 0.},
                                      {Branch::stomatocyte, 0.6, 0.2},
                                      {Branch::prolate, 0.35, 0.},
                                      {Branch::oblate, 0.7, 0.5}}) {
    const PointOutcome best = alone(case_of(branch, v, H0, 192));
    for (const int elements : {24, 48}) {
      SCOPED_TRACE(std::string(name(branch)) + " " + std::to_string(v) + " "
                   + std::to_string(elements));
      const PointOutcome point = alone(case_of(branch, v, H0, elements));
      ASSERT_EQ(point.row.status, PointStatus::stationary) << point.row.stop_reason;
      ASSERT_TRUE(point.row.error);
      EXPECT_LE(point.row.error->energy, 1e-8 * (1 + std::abs(energy_of(point))));
      EXPECT_LT(std::abs(energy_of(point) - energy_of(best)), point.row.error->energy + 1e-11);
      EXPECT_LT(std::abs(point.row.diagnostics->W2 - best.row.diagnostics->W2),
                point.row.error->W2 + 1e-8);
    }
  }
}

TEST(SpontaneousCurvature, is_reached_from_where_the_branch_is_sure) {
  struct Member {
    Branch branch;
    double H0, v, energy;
  };
  for (const auto& [branch, H0, v, energy] :
       {Member{Branch::stomatocyte, 0.3, 0.6, -8.4390},
        Member{Branch::stomatocyte, 0.3, 0.5, -8.4863},
        Member{Branch::stomatocyte, 0.5, 0.6, -8.1132}, Member{Branch::prolate, -2.4, 0.6, -13.507},
        Member{Branch::prolate, -2.4, 0.7, -13.731}}) {
    SCOPED_TRACE(std::string(name(branch)) + " " + std::to_string(H0) + " " + std::to_string(v));
    const PointOutcome point = alone(case_of(branch, v, H0));
    EXPECT_EQ(point.row.status, PointStatus::stationary) << point.row.stop_reason;
    EXPECT_EQ(point.row.negative_directions, 0);
    EXPECT_NEAR(energy_of(point), energy, branch == Branch::prolate ? 6e-4 : 6e-5);
  }
}

// On either side of where the neck closes, H₀ = 1.03991 at V_r = 0.6.
TEST(NarrowNecks, are_followed_until_they_close) {
  EXPECT_NEAR(axisym::closing_H0(axisym::sphere_in_sphere(0.6)), 1.03991, 1e-5);
  const PointOutcome open = alone(case_of(Branch::stomatocyte, 0.6, 1)),
                     closed = alone(case_of(Branch::stomatocyte, 0.6, 1.3));
  EXPECT_EQ(closed.row.status, PointStatus::limit);
  ASSERT_EQ(open.row.status, PointStatus::stationary) << open.row.stop_reason;
  EXPECT_EQ(open.row.negative_directions, 0);
  EXPECT_NEAR(axisym::thinnest_neck(open.state->X), 0.00103, 1e-5);
  EXPECT_NEAR(energy_of(open), -7.09821737, 1e-8);  // from 48, 96 and 192 elements on
  EXPECT_LT(open.row.error->energy, 1e-8);
}

// H₀ = 1.5 closes all necks up to V_r = 0.73, and so all ways from H₀ = 0; beyond they are open again.
TEST(OpenNecks, are_found_where_those_of_all_smaller_volumes_are_closed) {
  const StationaryCase of = case_of(Branch::stomatocyte, 0.9, 1.5);
  SshBranch branch(of.branch, of.material, of.numerics);
  const auto at = [&](double v) { return ssh_point(case_of(of.branch, v, 1.5), branch); };
  EXPECT_EQ(at(0.7).row.status, PointStatus::limit);
  const PointOutcome open = at(0.9), fold = at(0.95);
  ASSERT_EQ(open.row.status, PointStatus::stationary) << open.row.stop_reason;
  EXPECT_EQ(open.row.shape, "stomatocyte");
  EXPECT_EQ(open.row.negative_directions, 0);
  EXPECT_NEAR(energy_of(open), -4.672792866, 1e-8);  // from 48 and 96 elements
  EXPECT_EQ(fold.row.negative_directions, 0);
  ASSERT_TRUE(fold.row.diagnostics);
  EXPECT_NEAR(fold.row.diagnostics->reduced_volume, 0.912559, 1e-6);
}

TEST(FoldsOnTheWay, to_a_spontaneous_curvature_are_told_without_values) {
  const StationaryCase of = case_of(Branch::stomatocyte, 0.6, -4);
  SshBranch branch(of.branch, of.material, of.numerics);
  const auto end = branch.at(0.6);  // no state of the branch at any V_r: from SSH's without H₀
  ASSERT_TRUE(end);
  EXPECT_EQ(end->arrival, axisym::Arrival::fold);
  const double H0 = end->line.material_at(end->mu).spontaneous_curvature;
  EXPECT_LT(H0, 0);
  EXPECT_GT(H0, -4);
  const PointOutcome point = ssh_point(of, branch);
  EXPECT_EQ(point.row.status, PointStatus::unresolved);
  EXPECT_NE(point.row.stop_reason.find("ends in a fold at H0 = -0."), std::string::npos)
      << point.row.stop_reason;
  EXPECT_FALSE(point.row.diagnostics);
}

TEST(ClosedNecks, of_dumbbells_are_chains_of_equal_spheres) {
  const PointOutcome point = alone(case_of(Branch::prolate, 0.7, -4));
  EXPECT_EQ(point.row.status, PointStatus::limit) << point.row.stop_reason;
  ASSERT_TRUE(point.row.diagnostics);
  EXPECT_NEAR(point.row.diagnostics->reduced_volume, std::sqrt(0.5), 1e-12);
  const StationaryCase of = case_of(Branch::prolate, 0.5, -4);
  const axisym::TouchingSpheres four = axisym::chain_of_spheres(4);
  EXPECT_EQ(axisym::closing_H0(four), -4);
  const axisym::Diagnostics d = axisym::diagnose(of.material, four);
  EXPECT_NEAR(d.area, 4 * std::numbers::pi, 1e-12);
  EXPECT_NEAR(d.reduced_volume, 0.5, 1e-12);
  // H = H₀ everywhere: only the Gaussian energy is left, that of one sphere, and the potential.
  EXPECT_NEAR(d.energy.bending, 4 * std::numbers::pi * of.material.kappa_gauss(model::full_order),
              1e-12);
}

TEST(ClosedNecks, are_limits_with_the_energy_of_the_two_spheres) {
  const StationaryCase of = case_of(Branch::stomatocyte, 0.6, 2);
  const PointOutcome point = alone(of);
  EXPECT_EQ(point.row.status, PointStatus::limit);
  EXPECT_NE(point.row.stop_reason.find("a neck closes"), std::string::npos);
  ASSERT_TRUE(point.row.diagnostics);
  EXPECT_NEAR(point.row.diagnostics->area, 4 * std::numbers::pi, 1e-12);
  EXPECT_NEAR(point.row.diagnostics->reduced_volume, 0.6, 1e-12);
}

TEST(TwoSpheres, are_what_states_with_thin_necks_come_near_to) {
  double gap = 1;
  for (const double H0 : {0.4, 0.6, 0.8}) {
    const StationaryCase of = case_of(Branch::stomatocyte, 0.65, H0);
    const PointOutcome thin = alone(of);
    ASSERT_TRUE(thin.state) << thin.row.stop_reason;
    const auto spheres = axisym::sphere_in_sphere(0.65);
    EXPECT_LT(H0, axisym::closing_H0(spheres));
    const double closer =
        std::abs(energy_of(thin) - axisym::diagnose(of.material, spheres).energy.total());
    EXPECT_LT(closer, gap / 2);
    gap = closer;
  }
}

TEST(OrderedOblates, are_there_where_those_of_full_order_pass_through_themselves) {
  const StationaryCase classical = case_of(Branch::oblate, 0.5);
  const PointOutcome ssh = alone(classical);
  EXPECT_TRUE(ssh.row.self_contact);
  ASSERT_TRUE(has_state_here(ssh));
  StationaryCase of = classical;
  of.model = Model::SBEH;
  const PointOutcome ordered = order_from(of, *ssh.state);
  EXPECT_EQ(ordered.row.status, PointStatus::stationary) << ordered.row.stop_reason;
  EXPECT_NEAR(energy_of(ordered), -8.643176713, 1e-8);
  EXPECT_NEAR(ordered.row.diagnostics->thickness_pole, 0.095, 1e-3);
}

TEST(SshRows, that_are_limits_have_the_energy_of_the_spheres_at_every_L) {
  const StationaryCase of = case_of(Branch::stomatocyte, 0.6, 1);
  const PointOutcome limit{{.status = PointStatus::limit, .stop_reason = "a neck closes"}, {}};
  const auto spheres = axisym::sphere_in_sphere(0.6);
  for (const double L : {0.01, 0.05, 0.1}) {
    StationaryCase there = of;
    there.material = of.material.with_L(L);
    const PointOutcome row = without_ssh(there, limit, 0.05);
    EXPECT_EQ(row.row.status, PointStatus::limit);
    ASSERT_TRUE(row.row.diagnostics);
    EXPECT_EQ(row.row.diagnostics->energy.total(),
              axisym::diagnose(there.material, spheres).energy.total());
    there.model = Model::SBEH;
    EXPECT_FALSE(without_ssh(there, limit, 0.05).row.diagnostics);
  }
}

TEST(SshRows, that_are_folds_have_the_same_values_as_a_scan_of_their_L_alone) {
  const StationaryCase of = case_of(Branch::stomatocyte, 0.7);
  const PointOutcome fold = alone(of);
  StationaryCase there = of;
  there.material = of.material.with_L(0.02);
  const PointOutcome carried = without_ssh(there, fold, of.L()), own = alone(there);
  EXPECT_EQ(carried.row.stop_reason, own.row.stop_reason);
  EXPECT_EQ(carried.row.negative_directions, own.row.negative_directions);
  EXPECT_NEAR(energy_of(carried), energy_of(own), own.row.error->energy);
  EXPECT_NEAR(carried.row.error->energy / own.row.error->energy, 1, 0.5);
}

}  // namespace
}  // namespace sbeh::studies
