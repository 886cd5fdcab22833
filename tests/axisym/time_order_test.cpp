// How the result of a run converges with the time step: second order with extrapolation, first without.
#include "tests/axisym/cases.h"

namespace sbeh::axisym {
namespace {

using namespace test;

constexpr double begin = 0.02, duration = 0.08;
constexpr int elements = 48;  // with 24 the mesh's own motion, 1e-7, shows under the smallest steps

// What a run of equal steps ends with.
struct End {
  double energy, order_min, radius, thickness;
};
End run_of_equal_steps(Model model, const State& start, int steps, bool extrapolate) {
  const Material material = paper_material(0.05);
  Numerics numerics = with_elements(elements);
  numerics.tolerance = 0.1;
  numerics.first_step = numerics.largest_step = duration / steps;
  numerics.extrapolate = extrapolate;
  const FlowResult run =
      run_flow(material, model, start, target_of(0.8), numerics,
               {.end_time = duration, .output_times = {}, .stop_at_rest = false});
  EXPECT_EQ(run.stop, FlowStop::end_time);
  EXPECT_EQ(run.steps, steps);
  EXPECT_EQ(run.last.rejected, 0);
  const Diagnostics d = diagnose(material, run.state);
  return {d.energy.total(), d.order_min, d.radius_equator, d.thickness_pole};
}

struct Orders {
  double energy, order_min, radius, thickness;
};
Orders observed(Model model, bool extrapolate, const std::vector<int>& steps) {
  // Past the first moments, in which the spheroid's high modes decay within any step.
  const State start =
      run_flow(paper_material(0.05), model, ordered_spheroid(0.8, elements), target_of(0.8),
               with_elements(elements), {.end_time = begin, .output_times = {}})
          .state;
  std::printf("%s, %s\n", name(model), extrapolate ? "extrapolated" : "two half steps");
  OrderTable U("change of the energy from twice the step", "tau"), r("  of the radius", "tau"),
      z("  of the thickness", "tau"), beta("  of the smallest order", "tau");
  End before = run_of_equal_steps(model, start, steps[0] / 2, extrapolate);
  for (const int count : steps) {
    const End now = run_of_equal_steps(model, start, count, extrapolate);
    const double tau = duration / count;
    U.add(tau, now.energy - before.energy);
    r.add(tau, now.radius - before.radius);
    z.add(tau, now.thickness - before.thickness);
    beta.add(tau, now.order_min - before.order_min);
    before = now;
  }
  // The order of SSH does not change.
  return {.energy = U.print(),
          .order_min = model == Model::SSH ? 0 : beta.print(),
          .radius = r.print(),
          .thickness = z.print()};
}

TEST(TimeStep, extrapolated_is_of_second_order) {
  for (const Model model : {Model::SBEH, Model::SSH}) {
    const Orders p = observed(model, true, {32, 64, 128, 256});
    EXPECT_NEAR(p.energy, 2, 0.2);
    EXPECT_NEAR(p.radius, 2, 0.2);
    EXPECT_NEAR(p.thickness, 2, 0.2);
    if (model == Model::SBEH) {
      EXPECT_GT(p.order_min, 2);  // here τ² and τ³ nearly cancel
    }
  }
}

TEST(TimeStep, in_two_halves_is_of_first_order) {
  for (const Model model : {Model::SBEH, Model::SSH}) {
    const Orders p = observed(model, false, {16, 32, 64});
    EXPECT_NEAR(p.energy, 1, 0.1);
    EXPECT_NEAR(p.radius, 1, 0.1);
    EXPECT_NEAR(p.thickness, 1, 0.1);
    if (model == Model::SBEH) {
      EXPECT_NEAR(p.order_min, 1, 0.1);
    }
  }
}

}  // namespace
}  // namespace sbeh::axisym
