// dU/dt = −dissipation, and what the steps do to area and volume.
#include "tests/surface3d/cases.h"

#include <vector>

namespace sbeh::surface3d {
namespace {

using namespace test;

constexpr double duration = 1.6e-2;

// Equal first-order steps; `pulled`: back to the area and volume of the start.
struct Balance {
  double lost, spent;   // energy, and Σ τD
  double area, volume;  // relative drift at the end
  bool monotone;        // the energy
};
Balance run(const Surface& start, const Material& material, Model model, int steps, bool pulled) {
  const double tau = duration / steps;
  const Target begin = start.target();
  TimeStepper stepper(start.mesh, material, model);
  Surface s = start;
  const double U = energy_of(*s.mesh, material, s.state);
  double before = U;
  Balance sum{.lost = 0, .spent = 0, .area = 0, .volume = 0, .monotone = true};
  for (int k = 0; k < steps; ++k) {
    const FlowStep r = stepper.step(s.state, pulled ? begin : s.target(), tau);
    EXPECT_TRUE(r.ok());
    sum.spent += tau * r.dissipation.total();
    s.state = r.state;
    const double after = energy_of(*s.mesh, material, s.state);
    sum.monotone = sum.monotone && after < before;
    before = after;
  }
  sum.lost = U - before;
  sum.area = s.target().area / begin.area - 1;
  sum.volume = s.target().volume / begin.volume - 1;
  return sum;
}

TEST(EnergyLaw, holds_to_first_order_in_tau_up_to_the_error_of_the_mesh) {
  const Material material = paper_material(0.05);
  for (const Model model : {Model::SBEH, Model::SSH}) {
    const Surface start = relaxed_oblate(material, model, 320);
    std::vector<double> misses;
    for (const int steps : {4, 8, 16}) {
      const Balance b = run(start, material, model, steps, false);
      EXPECT_TRUE(b.monotone);
      misses.push_back(b.lost / b.spent - 1);
    }
    const double limit = 2 * misses[2] - misses[1];
    std::printf("%s: energy lost over dissipation - 1: %.4f %.4f %.4f -> %.4f\n", name(model),
                misses[0], misses[1], misses[2], limit);
    EXPECT_LT(std::abs(limit), 5e-3);  // the settling of the mesh moves the energy, too
    if (model == Model::SSH)
      EXPECT_NEAR(std::log2((misses[0] - misses[1]) / (misses[1] - misses[2])), 1, 0.15);
    else  // the terms of first order nearly cancel, so that those of second show
      EXPECT_LT(std::abs(misses[2]), std::abs(misses[0]) / 2);
  }
}

// What is left of the drift for τ → 0: nodes that move along the surface change the area of the mesh.
Eigen::Array2d drift_of(const Surface& start, const Material& material, int steps, bool pulled) {
  const Balance b = run(start, material, Model::SBEH, steps, pulled);
  return {b.area, b.volume};
}

TEST(Drift, of_area_and_volume_is_of_first_order_in_tau_and_pulled_back_of_second) {
  const Material material = paper_material(0.05);
  std::vector<double> left;
  for (const int triangles : {80, 320}) {
    const Surface start = relaxed_oblate(material, Model::SBEH, triangles);
    OrderTable drifting("drift of area and volume, change from half the step", "tau"),
        pulled("  the same, pulled back", "tau");
    Eigen::Array2d before = drift_of(start, material, 4, false), now = before;
    Eigen::Array2d pulled_before = drift_of(start, material, 4, true);
    for (const int steps : {8, 16, 32}) {
      before = now;
      now = drift_of(start, material, steps, false);
      const Eigen::Array2d pulled_now = drift_of(start, material, steps, true);
      drifting.add(duration / steps, (now - before).matrix().norm());
      pulled.add(duration / steps, (pulled_now - pulled_before).matrix().norm());
      pulled_before = pulled_now;
    }
    EXPECT_NEAR(drifting.print(), 1, 0.3);
    EXPECT_GT(pulled.print(), 1.5);
    left.push_back((2 * now - before).matrix().norm());
  }
  std::printf("left for tau -> 0: %.1e with 80, %.1e with 320 triangles\n", left[0], left[1]);
  EXPECT_LT(left[1], left[0] / 8);  // of third order in h
}

}  // namespace
}  // namespace sbeh::surface3d
