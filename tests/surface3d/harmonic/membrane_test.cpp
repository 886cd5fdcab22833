// The membrane by harmonics: its forces against differences of the energy, its flow against the theory of modes near the sphere, what
// it keeps, and what it refuses.
#include "meshing/spherical_harmonics.h"
#include "surface3d/harmonic/flow.h"
#include "tests/model/general_material.h"
#include "tests/model/sphere_theory.h"
#include "tests/order_table.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <numbers>

namespace sbeh::surface3d {
namespace {

using Eigen::Matrix3Xd;
using Eigen::MatrixX3d;
using Eigen::VectorXd;
using meshing::Harmonic;
using model::Material;
using model::Model;
using model::test::Amplitudes;
using model::test::TwoModes;
using sbeh::test::OrderTable;

// r = 1 + Σ u Y, β = order + Σ b Y
HarmonicMembrane star(const HarmonicMechanics& mechanics, const std::vector<Harmonic>& u,
                      double order, const std::vector<Harmonic>& b = {}) {
  Matrix3Xd x = mechanics.points();
  VectorXd beta(x.cols());
  for (Eigen::Index p = 0; p < x.cols(); ++p) {
    const Eigen::Vector3d omega = x.col(p);
    x.col(p) *= 1 + meshing::harmonic_sum(u, omega);
    beta[p] = order + meshing::harmonic_sum(b, omega);
  }
  return mechanics.through(x, beta);
}

HarmonicMembrane lump(const HarmonicMechanics& mechanics) {
  return star(mechanics, {{2, 1, 0.2}, {3, -2, 0.15}, {4, 3, 0.05}}, 0.55,
              {{1, 0, 0.1}, {2, 2, 0.05}});
}

double slope(const HarmonicMechanics::Measures& at, const HarmonicMembrane& rate) {
  return at.by_X.cwiseProduct(rate.X).sum() + at.by_beta.dot(rate.beta);
}

HarmonicMembrane moved(const HarmonicMembrane& from, double step, const HarmonicMembrane& rate) {
  return {from.X + step * rate.X, from.beta + step * rate.beta};
}

TEST(HarmonicMembrane, has_the_forces_that_differences_show) {
  const HarmonicMechanics mechanics(model::test::general_material(), Model::SBEH, 6);
  const HarmonicMembrane membrane = lump(mechanics);
  const auto at = mechanics.measure(membrane);
  ASSERT_TRUE(at);
  for (const unsigned seed : {1u, 2u, 3u}) {
    std::srand(seed);
    const HarmonicMembrane rate{MatrixX3d::Random(membrane.X.rows(), 3),
                                VectorXd::Random(membrane.X.rows())};
    constexpr double step = 1e-5;
    const double difference = (mechanics.measure(moved(membrane, step, rate))->energy.total()
                               - mechanics.measure(moved(membrane, -step, rate))->energy.total())
                            / (2 * step);
    EXPECT_NEAR(slope(*at, rate), difference, 1e-6 * std::abs(difference));
  }
}

// Whatever resists it: viscosity, friction along and across, both.
TEST(HarmonicMembrane, loses_what_it_dissipates_and_keeps_area_and_volume) {
  Material friction = model::test::general_material(), viscosity = friction;
  friction.viscosity = 0;
  friction.friction_normal = 2 * friction.friction_tangential;
  viscosity.friction_normal = viscosity.friction_tangential = 0;
  for (const Material& material : {model::test::general_material(), friction, viscosity}) {
    const HarmonicMechanics mechanics(material, Model::SBEH, 6);
    const HarmonicMembrane membrane = lump(mechanics);
    const auto at = mechanics.measure(membrane);
    const auto rates = mechanics.rates(membrane);
    ASSERT_TRUE(at && rates);
    const double spent = rates->dissipation.total();
    EXPECT_NEAR(slope(*at, rates->rate), -spent, 1e-10 * spent);
    constexpr double step = 1e-4;
    const auto after = mechanics.measure(moved(membrane, step, rates->rate)),
               before = mechanics.measure(moved(membrane, -step, rates->rate));
    EXPECT_NEAR(after->area, before->area, 1e-8);
    EXPECT_NEAR(after->volume, before->volume, 1e-8);
  }
}

TEST(HarmonicMembrane, moves_as_it_is_turned) {
  const HarmonicMechanics mechanics(model::test::general_material(), Model::SBEH, 6);
  const HarmonicMembrane membrane = lump(mechanics);
  const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, -1).normalized()).toRotationMatrix();
  const HarmonicMembrane turned{membrane.X * turn.transpose(), membrane.beta};
  const auto rates = mechanics.rates(membrane), of_turned = mechanics.rates(turned);
  EXPECT_LT((rates->rate.X * turn.transpose() - of_turned->rate.X).norm(),
            1e-9 * rates->rate.X.norm());
}

// ---- two modes near the sphere ------------------------------------------------------------------

// ∫ ρ Y over the sphere of directions, ρ the distance from the centre; see tests/surface3d/near_sphere_test.cpp.
double amplitude(int degree, const HarmonicMembrane& membrane, const Harmonic& mode) {
  const SphereRule rule = sphere_rule(2 * (degree + 1));
  const HarmonicBasis basis = harmonic_basis(degree, rule.omega);
  const MatrixX3d x = basis.Y[0] * membrane.X, x_s = basis.Y[1] * membrane.X,
                  x_t = basis.Y[2] * membrane.X;
  double sum = 0;
  for (Eigen::Index p = 0; p < x.rows(); ++p) {
    const Eigen::Vector3d at = x.row(p), a = x_s.row(p), b = x_t.row(p);
    const double rho = at.norm();
    sum += rule.weights[p] * meshing::spherical_harmonic(mode.l, mode.m, at / rho)
         * at.dot(a.cross(b)) / (rho * rho);
  }
  return sum;
}

// How much the ratio of Y_22 to Y_32 is off at the end, relative.
double miss(Model model, double eps, double sign) {
  constexpr int degree = 6;
  const Material material;
  const TwoModes theory(material, model);
  const HarmonicMechanics mechanics(material, model, degree);
  const Amplitudes begin{sign * eps, 0.8 * eps, sign * 0.3 * eps, -0.4 * eps};
  const Harmonic two{2, 2, begin[0]}, three{3, 2, begin[1]};
  const double order = theory.rest_order();
  const HarmonicMembrane start = model == Model::SSH ? star(mechanics, {two, three}, order)
                                                     : star(mechanics, {two, three}, order,
                                                            {{2, 2, begin[2]}, {3, 2, begin[3]}});
  double ratio = 0;
  const auto stop = flow_harmonics(
      mechanics, start, {.times = {theory.end_time() / 2}, .tolerance = 1e-11},
      [&](const HarmonicMoment& at) {
        ratio = amplitude(degree, at.membrane, two) / amplitude(degree, at.membrane, three);
      });
  EXPECT_EQ(stop, HarmonicFlowStop::end);
  return ratio / two_mode_ratios(theory, begin, 2)[0] - 1;
}

TEST(HarmonicFlow, of_two_modes_near_the_sphere_follows_the_theory) {
  for (const Model model : {Model::SSH, Model::SBEH}) {
    OrderTable mean("  mean of both signs", "epsilon");
    double last = 0, before = 0;
    for (const double eps : {0.04, 0.02}) {
      before = last;
      last = (miss(model, eps, 1) + miss(model, eps, -1)) / 2;
      mean.add(eps, last);
    }
    EXPECT_NEAR(mean.print(), 2, 0.3) << name(model);
    EXPECT_LT(std::abs(last + (last - before) / 3), 2e-5) << name(model);  // extrapolated
  }
}

TEST(HarmonicFlow, keeps_area_volume_and_energy_to_its_tolerance) {
  const HarmonicMechanics mechanics(Material{}, Model::SBEH, 6);
  const HarmonicMembrane start = lump(mechanics);
  std::vector<HarmonicMoment> moments;
  const auto stop = flow_harmonics(mechanics, start, {.times = {0.01, 0.02}, .tolerance = 1e-9},
                                   [&](const HarmonicMoment& at) { moments.push_back(at); });
  EXPECT_EQ(stop, HarmonicFlowStop::end);
  ASSERT_EQ(moments.size(), 3u);
  EXPECT_EQ(moments[1].time, 0.01);
  const HarmonicMoment &first = moments.front(), &last = moments.back();
  EXPECT_GT(first.measures.energy.total() - last.measures.energy.total(), 1e-2);
  EXPECT_NEAR(last.energy_before, first.measures.energy.total(), 1e-7);
  EXPECT_NEAR(last.measures.area, first.measures.area, 1e-7);
  EXPECT_NEAR(last.measures.volume, first.measures.volume, 1e-7);
}

TEST(HarmonicFlow, ends_where_it_is_told_to_or_cannot_go_on) {
  const HarmonicMechanics mechanics(Material{}, Model::SSH, 4);
  HarmonicMembrane start = lump(mechanics);
  int steps = 0;
  HarmonicSchedule schedule{.times = {1.}, .goes_on = [&](double) { return ++steps < 3; }};
  EXPECT_EQ(flow_harmonics(mechanics, start, schedule, [](const auto&) {}),
            HarmonicFlowStop::interrupted);
  EXPECT_EQ(steps, 3);
  start.X.setZero();
  schedule.goes_on = [](double) { return true; };
  EXPECT_EQ(flow_harmonics(mechanics, start, schedule, [](const auto&) {}),
            HarmonicFlowStop::degenerate);
  schedule.times = {0.2, 0.1};
  EXPECT_THROW(flow_harmonics(mechanics, start, schedule, [](const auto&) {}),
               std::invalid_argument);
}

TEST(HarmonicMechanics, refuses_what_it_does_not_have) {
  Material difference, conserved;
  difference.area_difference = {.stiffness = 1, .W2 = -25};
  conserved.order = model::OrderDynamics::conserved;
  conserved.mean_order = 0.5;
  EXPECT_THROW(HarmonicMechanics(difference, Model::SSH, 8), std::invalid_argument);
  EXPECT_THROW(HarmonicMechanics(conserved, Model::SBEH, 8), std::invalid_argument);
  EXPECT_THROW(HarmonicMechanics(Material{}, Model::HelfrichGlobal, 8), std::invalid_argument);
  EXPECT_THROW(HarmonicMechanics(Material{}, Model::SSH, 3), std::invalid_argument);
}

}  // namespace
}  // namespace sbeh::surface3d
