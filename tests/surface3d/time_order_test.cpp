// How the result converges with the time step: second order with extrapolation, first without.
#include "tests/surface3d/cases.h"

#include <vector>

namespace sbeh::surface3d {
namespace {

using namespace test;

constexpr double duration = 0.08;

// Orders at the end of the table of changes from twice the step.
struct Orders {
  double energy, radius, order_min;
};
Orders observed(Model model, bool extrapolate, int triangles, const std::vector<int>& steps) {
  const Material material = paper_material(0.05);
  Surface start = relaxed_oblate(material, model, triangles);
  settle_mesh(start, material, 30);
  std::printf("%s, %s, %d triangles\n", name(model),
              extrapolate ? "extrapolated" : "two half steps", triangles);
  OrderTable U("change of the energy from twice the step", "tau"), r("  of the radius", "tau"),
      beta("  of the smallest order", "tau");
  const auto radius = [](const State& s) { return s.X.topRows<2>().colwise().norm().maxCoeff(); };
  State before =
      run_of_equal_steps(start, material, model, duration, steps[0] / 2, extrapolate).state;
  for (const int count : steps) {
    const State now =
        run_of_equal_steps(start, material, model, duration, count, extrapolate).state;
    const double tau = duration / count;
    U.add(tau, energy_of(*start.mesh, material, now) - energy_of(*start.mesh, material, before));
    r.add(tau, radius(now) - radius(before));
    beta.add(tau, now.beta.minCoeff() - before.beta.minCoeff());
    before = now;
  }
  return {U.print(), r.print(), model == Model::SSH ? 0 : beta.print()};
}

// The mesh settles by the step and not by the time, so that its error also depends on τ, to first order:
// steps must be so large, or the mesh so fine, that this does not show.
TEST(TimeStep, extrapolated_is_of_second_order) {
  const Orders p = observed(Model::SBEH, true, 320, {4, 8});
  EXPECT_NEAR(p.energy, 2, 0.3);
  EXPECT_NEAR(p.radius, 2, 0.3);
  EXPECT_NEAR(p.order_min, 2, 0.3);
}

TEST(TimeStep, in_two_halves_is_of_first_order) {
  for (const Model model : {Model::SBEH, Model::SSH}) {
    const Orders p = observed(model, false, 80, {8, 16});
    EXPECT_NEAR(p.radius, 1, 0.25);
    if (model == Model::SBEH) {
      EXPECT_NEAR(p.order_min, 1, 0.4);
    }
  }
}

}  // namespace
}  // namespace sbeh::surface3d
