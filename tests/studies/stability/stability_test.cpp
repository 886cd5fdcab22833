// What a study of stability measures: amplitudes of modes, their growth rates, and the stability of classical
// oblates, which spherical harmonics know from the second variation.
#include "studies/stability/stability.h"

#include "meshing/revolution.h"
#include "meshing/shapes.h"
#include "studies/evolution/run_start.h"
#include "studies/stability/mode_amplitude.h"
#include "surface3d/harmonic/surface.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <functional>

namespace sbeh::studies {
namespace {

using model::Model;
using surface3d::Triangulation;

// ---- growth rates -------------------------------------------------------------------------------

// Steps that grow, as those of a run.
std::vector<AmplitudeAt> history_of(const std::function<double(double)>& amplitude, double end) {
  std::vector<AmplitudeAt> history;
  for (double t = 0, step = 1e-4; t <= end; t += step, step = std::min(1.5 * step, 0.1))
    history.push_back({t, amplitude(t)});
  return history;
}

TEST(GrowthRate, of_an_exponential_is_its_own) {
  for (const double rate : {0.03, -0.2}) {
    const auto growth =
        fit_growth(history_of([&](double t) { return 0.004 * std::exp(rate * t); }, 30));
    ASSERT_TRUE(growth);
    EXPECT_NEAR(growth->rate, rate, 1e-12);
    EXPECT_LT(growth->error, 1e-12);
  }
}

TEST(GrowthRate, is_that_of_the_slowest_mode_once_the_others_have_decayed) {
  const double slow = -0.03;
  const auto growth = fit_growth(
      history_of([&](double t) { return std::exp(slow * t) + 0.3 * std::exp(-1.5 * t); }, 30));
  ASSERT_TRUE(growth);
  EXPECT_NEAR(growth->rate, slow, growth->error + 1e-6);
  EXPECT_LT(growth->error, 1e-4);
  EXPECT_GT(growth->from, 3);
}

TEST(GrowthRate, begins_where_other_modes_are_known_to_have_decayed) {
  const auto history =
      history_of([](double t) { return std::exp(-0.03 * t) + 0.3 * std::exp(-1.5 * t); }, 30);
  const auto growth = fit_growth(history, 5.);
  ASSERT_TRUE(growth);
  EXPECT_NEAR(growth->from, 5, 0.11);
  EXPECT_NEAR(growth->rate, -0.03, 1e-4);
  EXPECT_EQ(fit_growth(history, 100.)->from, fit_growth(history)->from);  // too late
}

TEST(GrowthRate, has_an_error_that_tells_of_rates_that_change) {
  // From 0.05 to 0.03 over the window.
  const auto growth =
      fit_growth(history_of([](double t) { return std::exp(0.05 * t - 0.0005 * t * t); }, 20));
  ASSERT_TRUE(growth);
  EXPECT_GT(growth->error, 0.003);
  EXPECT_NEAR(growth->rate, 0.04, 0.01);
}

TEST(GrowthRate, is_taken_in_the_linear_regime_alone) {
  // Levels off at ten times the start.
  const auto growth =
      fit_growth(history_of([](double t) { return std::min(std::exp(0.2 * t), 10.); }, 100));
  ASSERT_TRUE(growth);
  EXPECT_NEAR(growth->rate, 0.2, 1e-9);
  EXPECT_NEAR(growth->to, std::log(most_growth) / 0.2, 0.2);
}

TEST(GrowthRate, needs_enough_amplitudes) {
  EXPECT_FALSE(fit_growth({}));
  EXPECT_FALSE(fit_growth({{0, 1}, {1, 2}, {2, 2.5}}));
  EXPECT_FALSE(fit_growth(history_of([](double) { return 0.; }, 30)));
}

// ---- amplitudes ---------------------------------------------------------------------------------

meshing::CurvedMesh spheroid() { return meshing::ellipsoid(0.8, false, {.triangles = 320}); }

double amplitude_of(const meshing::CurvedMesh& mesh, int l, int m) {
  return mode_amplitude(Triangulation(mesh), mesh.nodes, l, m);
}

TEST(ModeAmplitude, grows_with_the_displacement_and_is_0_without_one) {
  for (const auto& [l, m] : {std::pair{2, 2}, {3, 3}, {3, 2}, {3, 1}}) {
    // What is left is the mesh's own deviation from a surface of revolution.
    EXPECT_LT(amplitude_of(spheroid(), l, m), 1e-6) << l << m;
    std::array<double, 2> amplitude{};
    for (const int k : {0, 1}) {
      meshing::CurvedMesh mesh = spheroid();
      perturb(mesh, {{l, m, 0.002 * (k + 1)}});
      amplitude[std::size_t(k)] = amplitude_of(mesh, l, m);
    }
    EXPECT_GT(amplitude[0], 1e-4) << l << m;
    EXPECT_NEAR(amplitude[1] / amplitude[0], 2, 0.01) << l << m;
  }
}

TEST(ModeAmplitude, does_not_change_when_the_surface_is_shifted_or_turned_about_z) {
  meshing::CurvedMesh mesh = spheroid();
  perturb(mesh, {{2, 2, 0.01}});
  const double amplitude = amplitude_of(mesh, 2, 2);
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(0.4, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  mesh.nodes = (turn * mesh.nodes).eval();
  mesh.nodes.colwise() += Eigen::Vector3d(0.3, -0.1, 0.2);
  EXPECT_NEAR(amplitude_of(mesh, 2, 2), amplitude, 1e-14);
}

TEST(Roundness, tells_oblates_prolates_and_others) {
  const auto of = [](const Eigen::Vector3d& axes) {
    const meshing::CurvedMesh mesh = meshing::ellipsoid(axes, {.triangles = 80});
    return roundness_of(Triangulation(mesh), mesh.nodes);
  };
  EXPECT_EQ(of({1, 1.005, 0.5}), Roundness::oblate);
  EXPECT_EQ(of({0.5, 1, 0.505}), Roundness::prolate);
  EXPECT_EQ(of({1, 0.8, 0.5}), Roundness::triaxial);
}

// ---- states -------------------------------------------------------------------------------------

StabilityInput classical(double reduced_volume) {
  StabilityInput input;
  input.reduced_volume = {reduced_volume};
  input.L = {0.05};
  input.models = {Model::SSH};
  input.perturbations = {{2, 2, 0.01}};
  input.numerics_3d.largest_step = 0.5;
  input.end_time = 2;
  return input;
}

TEST(ClassicalOblate, leaves_where_its_energy_falls_in_two_directions_and_stays_where_it_does_not) {
  for (const auto& [v, verdict] : {std::pair{0.65, Verdict::stays}, {0.8, Verdict::leaves}}) {
    const StabilityInput input = classical(v);
    const auto run = run_perturbed(input, keys_of(input).front());
    ASSERT_TRUE(run);
    const StabilityResult& result = run->result;
    ASSERT_TRUE(result.growth && result.negative_directions);
    std::printf("V_r = %.2f: rate %.5f +- %.5f, by the modes %.5f, %d steps\n", v,
                result.growth->rate, result.growth->error, result.mode_rate, result.steps);
    EXPECT_EQ(result.verdict, verdict);
    EXPECT_EQ(result.witness, verdict);
    EXPECT_LT(std::abs(result.rate_difference), 3 * result.growth->error);
    EXPECT_EQ(result.growth->rate > 0, *result.negative_directions > 0);
    EXPECT_GT(std::abs(result.growth->rate), 5 * result.growth->error);
    // The perturbed surface has fallen below the saddle, or is nearly back at the minimum; the mesh's own
    // error of the energy is 1e-5.
    const double above = result.energy_end - result.energy_axisymmetric;
    if (verdict == Verdict::leaves)
      EXPECT_LT(above, -1e-5);
    else
      EXPECT_LT(std::abs(above), 2e-4);
  }
}

TEST(OrderedOblate, next_to_its_fold_leaves_in_two_ways_and_well_before_it_stays) {
  // At V_r = 0.6 the branch ends at L = 0.0706 and is a minimum among surfaces of revolution up to there.
  struct Row {
    double L;
    meshing::Harmonic mode;
    Verdict verdict;
  };
  for (const Row& row :
       {Row{0.05, {2, 2, 0.002}, Verdict::stays}, Row{0.07, {2, 2, 0.002}, Verdict::leaves},
        Row{0.07, {3, 1, 0.002}, Verdict::leaves}}) {
    StabilityInput input;
    input.reduced_volume = {0.6};
    input.L = {row.L};
    input.models = {Model::SBEH};
    input.perturbations = {row.mode};
    input.numerics_3d.largest_step = 0.02;
    input.end_time = 0.5;
    const auto run = run_perturbed(input, keys_of(input).front());
    ASSERT_TRUE(run && run->result.growth);
    std::printf("L = %.2f, m = %d: rate %.4f +- %.4f, by the modes %.4f, %d steps\n", row.L,
                row.mode.m, run->result.growth->rate, run->result.growth->error,
                run->result.mode_rate, run->result.steps);
    EXPECT_EQ(run->result.verdict, row.verdict);
    EXPECT_EQ(run->result.witness, row.verdict);
    EXPECT_FALSE(run->result.unresolved_from);
  }
}

// m = 1 decays at rates of −110 κ and −70 κ: what is left at 0.1/κ is the noise of the mesh.
TEST(Perturbation, that_has_gone_before_a_rate_can_be_told_has_none) {
  StabilityInput input;
  input.reduced_volume = {0.7, 0.8};
  input.L = {0.05};
  input.models = {Model::SSH, Model::SBEH};
  input.perturbations = {{3, 1, 0.005}};
  input.triangles = 80;
  for (const StabilityKey& key : keys_of(input)) {
    const auto run = run_perturbed(input, key);
    ASSERT_TRUE(run);
    EXPECT_EQ(run->result.verdict, Verdict::stays);
    EXPECT_EQ(run->result.witness, Verdict::stays);
    EXPECT_FALSE(run->result.growth) << run->result.growth->rate;
    EXPECT_LT(run->result.end_time, 2.2);
  }
}

// It is gone before a displacement along a harmonic has settled.
TEST(Perturbation, that_is_the_mode_itself_has_its_rate_within_what_a_coarser_run_says) {
  StabilityInput input;
  input.reduced_volume = {0.8};
  input.L = {0.05};
  input.models = {Model::SBEH};
  input.perturbations = {{3, 1, 0.002}};
  input.start = StabilityStart::mode;
  input.triangles = 180;
  input.coarser = 80;
  input.end_time = 0.5;
  const auto run = run_perturbed(input, keys_of(input).front());
  ASSERT_TRUE(run && run->result.growth);
  const StabilityResult& result = run->result;
  std::printf("m = 1: rate %.5f +- %.5f, by the modes %.5f, %d steps\n", result.growth->rate,
              result.growth->error, result.mode_rate, result.steps);
  EXPECT_EQ(result.witness, Verdict::stays);
  EXPECT_GE(result.growth->error, std::abs(result.growth->rate - result.coarser_rate));
  EXPECT_LT(std::abs(result.rate_difference), result.growth->error);
  EXPECT_LT(std::abs(result.rate_difference), 0.005 * std::abs(result.mode_rate));
  EXPECT_LT(result.growth->error, 0.1 * std::abs(result.mode_rate));
}

StabilityResult row_of(Model model, double volume, double eigenvalue, int m = 2) {
  StabilityResult row;
  row.key = {{volume, 0.05, model, axisym::Branch::oblate}, m, m};
  row.eigenvalue = eigenvalue;
  return row;
}

// That of the line of a scan, see studies/docs/stability.md.
TEST(Thresholds, lie_where_the_eigenvalue_is_0_on_the_branch_between_two_rows) {
  const auto found =
      find_thresholds({}, {row_of(Model::SBEH, 0.7, 1), row_of(Model::SBEH, 0.8, -1)});
  ASSERT_EQ(found.size(), 1u);
  EXPECT_NEAR(found[0].reduced_volume, 0.75098177, 2e-8);
  EXPECT_LT(found[0].error, 1e-7);
  EXPECT_TRUE(
      find_thresholds({}, {row_of(Model::SSH, 0.7, -1), row_of(Model::SSH, 0.8, -1)}).empty());
  EXPECT_TRUE(
      find_thresholds({}, {row_of(Model::SSH, 0.7, 1), row_of(Model::SSH, 0.8, -1, 3)}).empty());
}

TEST(Thresholds, that_the_branch_does_not_have_are_between_their_rows) {
  const auto found = find_thresholds({}, {row_of(Model::SSH, 0.6, 1), row_of(Model::SSH, 0.7, -1)});
  ASSERT_EQ(found.size(), 1u);
  EXPECT_TRUE(std::isnan(found[0].reduced_volume));
  EXPECT_EQ(found[0].below.reduced_volume, 0.6);
  EXPECT_EQ(found[0].upper_volume, 0.7);
}

}  // namespace
}  // namespace sbeh::studies
