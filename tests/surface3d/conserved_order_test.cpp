// Membranes whose order is conserved, in 3D: their states against the axisymmetric solver, by all integrators, and the energy law.
#include "axisym/diagnostics.h"
#include "axisym/domains.h"
#include "axisym/flow.h"
#include "axisym/modes/eigenmodes.h"
#include "axisym/start_shapes.h"
#include "axisym/stationary/stationary.h"
#include "surface3d/domains.h"
#include "surface3d/order_step.h"
#include "surface3d/stationary/eigenmodes.h"
#include "surface3d/stationary/path.h"
#include "surface3d/stationary/stationary.h"
#include "tests/model/two_phases.h"
#include "tests/surface3d/energy_balance.h"
#include "tests/surface3d/stationary/places.h"

#include <algorithm>

namespace sbeh::surface3d {
namespace {

using namespace test;
using model::OrderDynamics;
using model::test::two_phases;

const Target target{4 * pi, 0.9 * 4 * pi / 3};

// Rich around the north pole, at rest.
struct TwoPhases {
  Material material;
  axisym::StationaryState state;
  double energy;
};
TwoPhases axisymmetric() {
  const auto X = axisym::spheroid(0.9, false, 96, 0.5);
  axisym::State start{X, axisym::Field(X.cols())};
  for (Eigen::Index i = 0; i < X.cols(); ++i)
    start.beta[i] = 0.35 + 0.25 * std::tanh((X(1, i) - 0.3) / 0.25);
  const Material material =
      two_phases(0.03, 5, axisym::diagnose({}, start).order_mean, OrderDynamics::conserved);
  axisym::Numerics numerics;
  numerics.tolerance = 1e-4;
  const auto run = axisym::run_flow(material, Model::SBEH, start, target, numerics,
                                    {.end_time = 400, .output_times = {}});
  EXPECT_EQ(run.stop, FlowStop::at_rest);
  const auto found = axisym::solve_stationary(material, Model::SBEH, target,
                                              axisym::guess_from(material, Model::SBEH, run.state));
  EXPECT_EQ(found.status, axisym::NewtonStatus::converged);
  return {material, found.state, axisym::diagnose(material, found.state).energy.total()};
}

double mean_order(const Surface& s) {
  return total_order(*s.mesh, s.state) / area(*s.mesh, s.state.X);
}
// With the area and the volume of the target, and its mean order.
Surface placed(const TwoPhases& exact, int triangles) {
  Surface s = revolved(exact.state, triangles);
  EXPECT_TRUE(correct_area_volume(*s.mesh, s.state.X, target.area, target.volume));
  s.state.beta.array() += *exact.material.mean_order - mean_order(s);
  return s;
}

TEST(Domains, are_counted_and_measured) {
  // Two caps of different heights on a sphere.
  const Surface sphere = uniform_sphere(0, 1280);
  const auto with_caps = [&](double north, double south) {
    State s = sphere.state;
    for (int i = 0; i < sphere.mesh->nodes; ++i) {
      const double z = s.X(2, i);
      s.beta[i] = 0.35 + 0.25 * std::tanh(std::max(z - north, -z - south) / 0.2);
    }
    return domains_of(*sphere.mesh, s);
  };
  const model::Domains two = with_caps(0.5, 0.6), one = with_caps(0.5, 2);
  EXPECT_EQ(two.count, 2);
  EXPECT_EQ(one.count, 1);
  // The middle of the extremes is not that of the profile by less than 2e-2 of the width.
  EXPECT_NEAR(two.area, 2 * pi * (0.5 + 0.4), 0.05);
  EXPECT_NEAR(two.boundary, 2 * pi * (std::sqrt(0.75) + 0.8), 0.05);
  EXPECT_NEAR(one.area, 2 * pi * 0.5, 0.05);
  State uniform = sphere.state;
  uniform.beta.setConstant(0.4);
  EXPECT_EQ(domains_of(*sphere.mesh, uniform).count, 0);
}

TEST(ConservedOrder3d, has_the_states_and_modes_of_the_axisymmetric_solver) {
  const TwoPhases exact = axisymmetric();
  std::vector<double> expected;
  const auto second = axisym::second_variation(exact.material, Model::SBEH, exact.state);
  for (int m = 0; m <= 4; ++m) {
    const auto spectrum = axisym::lowest_modes(second, m, 3);
    ASSERT_TRUE(spectrum);
    for (const axisym::Eigenmode& mode : spectrum->modes)
      for (int copy = 0; copy < (m == 0 ? 1 : 2); ++copy) expected.push_back(mode.eigenvalue);
  }
  std::ranges::sort(expected);
  constexpr int count = 6;
  const model::Domains flat = axisym::domains_of(exact.state);
  EXPECT_EQ(flat.count, 2);  // the soft phase has gone to the rim
  OrderTable energies("energy", "h"), potentials("chemical potential", "h"),
      eigenvalues("largest error of six eigenvalues", "h");
  double error = 0;
  for (const int triangles : {80, 320, 1280}) {
    const Surface start = revolved(exact.state, triangles);
    NewtonSystem system(*start.mesh, exact.material, Model::SBEH);
    const NewtonResult found = solve_stationary(
        system, target, guess_from(*start.mesh, exact.material, Model::SBEH, start.state));
    ASSERT_EQ(found.status, NewtonStatus::converged);
    ASSERT_TRUE(system.linearise(found.state, found.normals));
    const double h = 1 / std::sqrt(start.mesh->count());
    error = energy(exact.material, *start.mesh, found.state).total() - exact.energy;
    energies.add(h, error);
    potentials.add(h, found.state.chemical_potential - exact.state.chemical_potential);
    EXPECT_NEAR(mean_order({start.mesh, found.state}), *exact.material.mean_order, 1e-6);
    const model::Domains domains = domains_of(*start.mesh, found.state);
    EXPECT_EQ(domains.count, flat.count) << triangles;
    EXPECT_NEAR(domains.area, flat.area, 2 * h * h * 4 * pi);
    EXPECT_NEAR(domains.boundary, flat.boundary, 2 * h * h * 4 * pi);
    if (triangles < 320) continue;
    EXPECT_EQ(found.negative_directions,
              std::ranges::count_if(expected, [](double value) { return value < 0; }));
    const auto modes = lowest_modes(system, found.state, found.normals, count);
    ASSERT_TRUE(modes && int(modes->size()) == count);
    double worst = 0;
    for (std::size_t k = 0; k < count; ++k)
      worst = std::max(worst, std::abs((*modes)[k].eigenvalue - expected[k]));
    eigenvalues.add(h, worst);
  }
  energies.print();
  EXPECT_LT(std::abs(error), 1e-6);
  EXPECT_GT(energies.orders().back(), 3.5);
  EXPECT_GT(potentials.print(), 3);
  EXPECT_GT(eigenvalues.print(), 3);
}

// μ_β is what more order costs, along a path, too.
TEST(ConservedOrder3d, is_followed_in_its_mean) {
  const TwoPhases exact = axisymmetric();
  const Surface start = revolved(exact.state, 180);
  const auto material_at = [&](double mu) {
    Material material = exact.material;
    *material.mean_order += 0.05 * mu;
    return material;
  };
  const Path path(*start.mesh, Model::SBEH, material_at, [](double) { return target; });
  const auto point =
      settled(path, guess_from(*start.mesh, path.material(0), Model::SBEH, start.state), 0);
  ASSERT_TRUE(point);
  double ds = 0.2;
  const auto first = advance(path, *point, ds, 1e-3);
  ASSERT_TRUE(first);
  EXPECT_GT(std::abs(first->mu), 0.01);
  const auto energy_at = [&](double mu) {
    const auto there = settled(path, *first, mu);
    return energy(path.material(mu), *start.mesh, *there).total();
  };
  const auto middle = settled(path, *first, first->mu);
  ASSERT_TRUE(middle);
  constexpr double h = 0.02;
  const double slope = (energy_at(first->mu + h) - energy_at(first->mu - h)) / (2 * h);
  EXPECT_NEAR(slope / (0.05 * target.area), middle->chemical_potential, 1e-5);
}

TEST(ConservedOrder3d, comes_near_rest_there_by_all_integrators) {
  const TwoPhases exact = axisymmetric();
  Surface start = placed(exact, 80);
  for (int i = 0; i < start.mesh->nodes; ++i)  // a wider interface, at the same place
    start.state.beta[i] = 0.35 + 0.25 * std::tanh((start.state.X(2, i) - 0.32) / 0.4);
  start.state.beta.array() += *exact.material.mean_order - mean_order(start);
  const double total = total_order(*start.mesh, start.state);
  for (const OrderDynamics dynamics : {OrderDynamics::conserved, OrderDynamics::diffusive})
    for (const Integrator integrator :
         {Integrator::two_step, Integrator::step_doubling, Integrator::variational}) {
      Material material = exact.material;
      material.order = dynamics;
      Numerics numerics;
      numerics.tolerance = 1e-3;
      numerics.integrator = integrator;
      const auto run = [&] {
        return run_flow(material, Model::SBEH, start.moment(), numerics,
                        {.end_time = 15, .output_times = {}});
      };
      if (dynamics == OrderDynamics::diffusive && integrator == Integrator::step_doubling) continue;
      if (dynamics == OrderDynamics::diffusive && integrator == Integrator::variational) {
        EXPECT_THROW(run(), std::invalid_argument);
        continue;
      }
      const FlowResult end = run();
      EXPECT_NEAR(total_order(*start.mesh, end.state) / total, 1, 1e-11) << name(integrator);
      NewtonSystem system(*start.mesh, material, Model::SBEH);
      const NewtonResult found = solve_stationary(
          system, target, guess_from(*start.mesh, material, Model::SBEH, end.state));
      ASSERT_EQ(found.status, NewtonStatus::converged);
      const double before = energy(material, *start.mesh, {start.state, found.state.H}).total(),
                   rest = energy(material, *start.mesh, {end.state, found.state.H}).total(),
                   U = energy(material, *start.mesh, found.state).total();
      std::printf(
          "%s, %s: %d steps, t = %.1f, U = %.9f, Newton's %.9f, axisymmetric %.9f, "
          "the start's %.6f\n",
          name(dynamics), name(integrator), end.steps, end.last.time, rest, U, exact.energy,
          before);
      // The slowest mode decays at the rate 0.16, its energy twice as fast: e^{-4.8} is left of it.
      EXPECT_GT(rest, U);
      EXPECT_LT(rest - U, 0.01 * (before - U)) << name(integrator);
      EXPECT_NEAR(U, exact.energy, 2e-3) << name(integrator);
    }
}

TEST(ConservedOrder3d, has_its_energy_law_to_first_order_in_tau) {
  const TwoPhases exact = axisymmetric();
  Surface start = placed(exact, 320);
  for (int i = 0; i < start.mesh->nodes; ++i)
    start.state.beta[i] = 0.35 + 0.2 * std::tanh((start.state.X(2, i) - 0.4) / 0.5);
  start.state.beta.array() += *exact.material.mean_order - mean_order(start);
  Target kept = start.target();
  kept.order = total_order(*start.mesh, start.state);
  // What the interpolation has left is gone after it.
  start.state = energy_balance_of(exact.material, start, kept, 4e-3, 20).end;
  for (const OrderDynamics dynamics : {OrderDynamics::conserved, OrderDynamics::diffusive}) {
    Material material = exact.material;
    material.order = dynamics;
    expect_energy_law(name(dynamics), material, start, kept, 0.01, 16);
  }
}

}  // namespace
}  // namespace sbeh::surface3d
