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

TEST(Drift, of_area_and_volume_is_of_first_order_in_tau_and_pulled_back_of_second) {
  const Material material = paper_material(0.05);
  const Surface start = relaxed_oblate(material, Model::SBEH, 80);
  OrderTable area("drift of the area", "tau"), volume("  of the volume", "tau"),
      pulled_area("  of the area, pulled back", "tau"),
      pulled_volume("  of the volume, pulled back", "tau");
  for (const int steps : {4, 8, 16}) {
    const Balance drifting = run(start, material, Model::SBEH, steps, false);
    const Balance pulled = run(start, material, Model::SBEH, steps, true);
    area.add(duration / steps, drifting.area);
    volume.add(duration / steps, drifting.volume);
    pulled_area.add(duration / steps, pulled.area);
    pulled_volume.add(duration / steps, pulled.volume);
  }
  EXPECT_NEAR(area.print(), 1, 0.3);
  EXPECT_NEAR(volume.print(), 1, 0.3);
  // The tangential motion of the mesh changes the area, too, and here with the other sign.
  EXPECT_GT(pulled_area.print(), 1.5);
  EXPECT_NEAR(pulled_volume.print(), 2, 0.5);
}

}  // namespace
}  // namespace sbeh::surface3d
