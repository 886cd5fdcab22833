// The 3D solver against the axisymmetric one: states of rest, and the way there.
#include "tests/axisym/cases.h"
#include "tests/surface3d/cases.h"

#include <limits>
#include <vector>

namespace sbeh::surface3d {
namespace {

using namespace test;

constexpr double L = 0.05, V_r = 0.8;
constexpr int triangles = 320, elements = 48;
const Target target{4 * pi, V_r * 4 * pi / 3};

// ---- states of rest ---------------------------------------------------------------------------------

void expect_same_rest(Model model) {
  const Material material = paper_material(L);
  const auto exact = axisym::test::oblate(model, {V_r, L}, elements);
  const double U = axisym::test::energy_of(material, exact).total();
  const double rim = axisym::diagnose(material, exact).order_min;

  const Surface s = ordered_spheroid(V_r, triangles);
  Numerics numerics;
  numerics.tolerance = 1e-3;
  numerics.rest_speed = 1e-5;
  const FlowResult run = run_flow(material, model, {s.mesh, s.state, target}, numerics,
                                  {.end_time = 3, .output_times = {}},
                                  [&](const FlowRecord& r, const State& x, const StepView&, bool) {
                                    EXPECT_NEAR(area(*s.mesh, x.X) / target.area, 1, 1e-8);
                                    EXPECT_NEAR(volume(*s.mesh, x.X) / target.volume, 1, 1e-8);
                                    EXPECT_EQ(r.rises.sum, 0) << "t = " << r.time;
                                    return true;
                                  });
  const Diagnostics d = diagnose(*s.mesh, material, run.state);
  std::printf(
      "%s: %s at t = %.2f after %d steps: U = %.8f, axisymmetric %.8f, relative %.1e; "
      "order at the rim %.6f, axisymmetric %.6f\n",
      name(model), describe(run.stop).c_str(), run.last.time, run.steps, d.energy.total(), U,
      d.energy.total() / U - 1, d.order_min, rim);
  EXPECT_EQ(run.stop, FlowStop::at_rest);
  EXPECT_NEAR(d.energy.total() / U, 1, 1e-5);
  EXPECT_NEAR(d.order_min, rim, 1e-3);
}

TEST(Ellipsoid, of_SSH_comes_to_rest_at_the_axisymmetric_oblate) { expect_same_rest(Model::SSH); }

TEST(Ellipsoid, of_SBEH_comes_to_rest_at_the_axisymmetric_oblate) { expect_same_rest(Model::SBEH); }

// ---- histories --------------------------------------------------------------------------------------

// Energies at an eighth, a half and the end of the duration, with equal first-order steps.
constexpr double duration = 0.04;
using History = Eigen::Array3d;
bool is_output(int step, int steps) {
  return step == steps / 8 || step == steps / 2 || step == steps;
}

History axisymmetric_history(Model model, int steps) {
  const Material material = paper_material(L);
  axisym::State s = axisym::test::ordered_spheroid(V_r, elements);
  axisym::TimeStepper stepper(material, model, elements);
  History U;
  int output = 0;
  for (int k = 1; k <= steps; ++k) {
    const axisym::FlowStep r = stepper.step(s, target, duration / steps);
    EXPECT_TRUE(r.ok());
    s = r.state;
    if (is_output(k, steps)) U[output++] = axisym::test::energy_of(material, s).total();
  }
  return U;
}

History history(Model model, Scheme scheme, int count, int steps) {
  const Material material = paper_material(L);
  const Surface start = ordered_spheroid(V_r, count);
  TimeStepper stepper(start.mesh, material, model, numerics_of(scheme));
  State s = start.state;
  History U;
  int output = 0;
  for (int k = 1; k <= steps; ++k) {
    const FlowStep r = stepper.step(s, target, duration / steps);
    EXPECT_TRUE(r.ok());
    s = r.state;
    if (is_output(k, steps)) U[output++] = energy_of(*start.mesh, material, s);
  }
  return U;
}

void print(const char* what, int steps, const History& U) {
  std::printf("%-14s %3d steps: %.6f %.6f %.6f\n", what, steps, U[0], U[1], U[2]);
}

// The monolithic scheme is the axisymmetric one but for the mesh: both err alike in τ.
void expect_same_history(Model model) {
  const History coarse = axisymmetric_history(model, 8), fine = axisymmetric_history(model, 16);
  const History coarse_3d = history(model, Scheme::monolithic, triangles, 8),
                fine_3d = history(model, Scheme::monolithic, triangles, 16);
  const History rough_3d = history(model, Scheme::monolithic, 80, 16);
  print("axisymmetric", 8, coarse);
  print("monolithic", 8, coarse_3d);
  print("axisymmetric", 16, fine);
  print("monolithic", 16, fine_3d);
  const History miss = (fine_3d - fine).abs(), rough = (rough_3d - fine).abs();
  std::printf("difference with 80 triangles %.1e %.1e %.1e, with 320 %.1e %.1e %.1e\n", rough[0],
              rough[1], rough[2], miss[0], miss[1], miss[2]);
  // The error of the mesh, largest in the violent beginning.
  EXPECT_LT(miss[0], 2e-3 * std::abs(fine[0]));
  EXPECT_LT(miss[2], 1e-4 * std::abs(fine[2]));
  EXPECT_LT(miss[2], rough[2] / 8);  // h³ at least
  const History change = coarse - fine, change_3d = coarse_3d - fine_3d;
  EXPECT_TRUE(((change_3d - change).abs() < 0.1 * change.abs() + miss).all());
}

TEST(History, of_SSH_is_the_axisymmetric_one_but_for_the_mesh) { expect_same_history(Model::SSH); }

TEST(History, of_SBEH_is_the_axisymmetric_one_but_for_the_mesh) {
  expect_same_history(Model::SBEH);
}

// ---- the two schemes --------------------------------------------------------------------------------

TEST(Schemes, differ_by_first_order_in_tau_in_motion) {
  OrderTable table("split against monolithic: energy at the end", "tau");
  for (const int steps : {16, 32})
    table.add(duration / steps, history(Model::SSH, Scheme::split, triangles, steps)[2]
                                    - history(Model::SSH, Scheme::monolithic, triangles, steps)[2]);
  EXPECT_NEAR(table.print(), 1, 0.25);
}

TEST(Schemes, come_to_the_same_rest) {
  const Material material = paper_material(L);
  std::vector<Diagnostics> ends;
  for (const Scheme scheme : {Scheme::split, Scheme::monolithic}) {
    const Surface s = ordered_spheroid(V_r, 80);
    TimeStepper stepper(s.mesh, material, Model::SBEH, numerics_of(scheme));
    State now = s.state;
    for (int k = 0; k < 60; ++k) {
      FlowStep r = stepper.step(now, target, k < 20 ? 2e-3 : 0.05);
      ASSERT_TRUE(r.ok());
      now = r.state;
    }
    ends.push_back(diagnose(*s.mesh, material, now));
    std::printf("U = %.8f, order at the rim %.7f, A %.1e\n", ends.back().energy.total(),
                ends.back().order_min, ends.back().area / target.area - 1);
    // Pulled back in every step: at rest A and V are those asked for.
    EXPECT_NEAR(ends.back().area / target.area, 1, 1e-6);
    EXPECT_NEAR(ends.back().volume / target.volume, 1, 1e-6);
  }
  EXPECT_NEAR(ends[0].energy.total() / ends[1].energy.total(), 1, 1e-5);
  EXPECT_NEAR(ends[0].order_min, ends[1].order_min, 1e-4);
}

}  // namespace
}  // namespace sbeh::surface3d
