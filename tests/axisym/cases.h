// Start shapes, stationary states and tables of observed orders which the tests of axisym share.
#pragma once

#include "axisym/curvature.h"
#include "axisym/diagnostics.h"
#include "axisym/flow.h"
#include "axisym/redistribute.h"
#include "axisym/start_shapes.h"
#include "axisym/stationary/continuation.h"
#include "tests/order_table.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <limits>
#include <numbers>
#include <ostream>
#include <string>
#include <vector>

namespace sbeh::axisym {

// Words instead of bytes in GoogleTest's messages.
inline void PrintTo(FlowStop stop, std::ostream* out) {  // NOLINT: GoogleTest's name
  *out << describe(stop);
}

}  // namespace sbeh::axisym

namespace sbeh::axisym::test {

using model::Material;
using model::Model;
using sbeh::test::OrderTable;
using std::numbers::pi;

/// The one-constant material of the paper.
inline Material paper_material(double L) { return Material{}.with_L(L); }

/// Fully ordered oblate spheroid of area 4π: where the paper's runs start.
inline State ordered_spheroid(double reduced_volume, int elements) {
  State s{.X = spheroid(reduced_volume, false, elements, Numerics{}.grading), .beta = {}};
  s.beta = Field::Constant(s.X.cols(), model::full_order);
  return s;
}

/// Energy with the curvature that the curve itself defines, as run_flow reports it.
inline Energy energy_of(const Material& material, const State& s) {
  return energy(material, s, mean_curvature(s.X));
}
/// Energy of a stationary state, with its own curvature field.
inline Energy energy_of(const Material& material, const StationaryState& s) {
  return energy(material, s, s.H);
}

/// What equal steps come to.
struct EnergyBalance {
  double excess;  ///< the energy that they lose over the sum of τD that they dissipate, less 1
  State end;
};
inline EnergyBalance energy_balance_of(const Material& material, Model model, const State& start,
                                       const Target& target, double duration, int steps) {
  TimeStepper stepper(material, model, element_count(start.X));
  const double tau = duration / steps;
  State s = start;
  double spent = 0;
  for (int k = 0; k < steps; ++k) {
    const FlowStep r = stepper.step(s, target, tau);
    EXPECT_TRUE(r.ok());
    if (!r.ok()) return {std::numeric_limits<double>::quiet_NaN(), s};
    spent += tau * r.dissipation.total();
    s = r.state;
  }
  const double lost = energy_of(material, start).total() - energy_of(material, s).total();
  return {lost / spent - 1, s};
}

/// U_EL, the part of the energy that is linear in L: everything but the potential.
inline double elastic(const Energy& e) { return e.distortion + e.bending; }

inline Numerics with_elements(int elements) {
  Numerics numerics;
  numerics.elements = elements;
  return numerics;
}

/// Newton from a guess at a point of the plane; must converge.
inline BranchState settled(Model model, PlanePoint at, const StationaryState& guess) {
  const NewtonResult r =
      solve_stationary(paper_material(at.L), model, target_of(at.reduced_volume), guess);
  EXPECT_EQ(r.status, NewtonStatus::converged) << "V_r = " << at.reduced_volume;
  return {r.state, at, r.determinant_sign};
}

/// The smooth oblate at (0.8, 0.05): a short run from the spheroid, then Newton.
inline BranchState first_oblate(Model model, int elements = 24) {
  const PlanePoint at{0.8, 0.05};
  const Material material = paper_material(at.L);
  Numerics numerics = with_elements(elements);
  numerics.tolerance = 1e-4;
  const FlowResult run =
      run_flow(material, model, ordered_spheroid(at.reduced_volume, elements),
               target_of(at.reduced_volume), numerics, {.end_time = 0.2, .output_times = {}});
  return settled(model, at, redistribute(guess_from(material, model, run.state), numerics.grading));
}

/// The same state on another number of elements.
inline BranchState refined(Model model, const BranchState& b, int elements) {
  return settled(model, b.at, redistribute(b, Numerics{}.grading, elements));
}

/// Follows the branch to a point which it must reach.
inline BranchState reach(Model model, const BranchState& from, PlanePoint to) {
  const FollowResult r =
      follow(paper_material(from.at.L), model, from, to, with_elements(element_count(from.X)));
  EXPECT_EQ(r.arrival, Arrival::reached) << "V_r = " << to.reduced_volume << ", L = " << to.L;
  return r.state;
}

/// The smooth oblate at any point of the plane before the fold.
inline BranchState oblate(Model model, PlanePoint at, int elements) {
  return refined(model, reach(model, first_oblate(model), at), elements);
}

}  // namespace sbeh::axisym::test
