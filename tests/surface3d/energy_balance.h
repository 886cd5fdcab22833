// The energy law of equal steps, where the order is free.
#pragma once

#include "tests/surface3d/cases.h"

#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace sbeh::surface3d::test {

/// What equal first-order steps of SBEH come to.
struct EnergyBalance {
  double excess;  ///< the energy that they lose over the sum of τD that they dissipate, less 1
  State end;
};
inline EnergyBalance energy_balance_of(const Material& material, const Surface& start,
                                       const Target& target, double duration, int steps) {
  TimeStepper stepper(start.mesh, material, Model::SBEH, {});
  const double tau = duration / steps;
  State s = start.state;
  double spent = 0;
  for (int k = 0; k < steps; ++k) {
    const FlowStep r = stepper.step(s, target, tau);
    EXPECT_TRUE(r.ok());
    if (!r.ok()) return {std::numeric_limits<double>::quiet_NaN(), s};
    spent += tau * r.dissipation.total();
    s = r.state;
  }
  const double lost =
      energy_of(*start.mesh, material, start.state) - energy_of(*start.mesh, material, s);
  return {lost / spent - 1, s};
}

/// That dU/dt = −D to first order in τ, by so many steps, twice and four times as many; what is left for τ → 0 is the mesh's.
inline void expect_energy_law(const std::string& name, const Material& material,
                              const Surface& start, const Target& target, double duration,
                              int steps) {
  OrderTable table(name + ": energy lost against the sum of tau D, relative, change", "tau");
  std::vector<double> excess;
  for (const int count : {steps, 2 * steps, 4 * steps}) {
    excess.push_back(energy_balance_of(material, start, target, duration, count).excess);
    if (excess.size() > 1) table.add(duration / count, excess.end()[-1] - excess.end()[-2]);
  }
  EXPECT_NEAR(table.print(), 1, 0.2) << name;
  EXPECT_LT(std::abs(2 * excess[2] - excess[1]), 5e-3) << name;
}

}  // namespace sbeh::surface3d::test
