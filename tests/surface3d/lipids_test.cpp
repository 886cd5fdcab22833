// Membranes whose lipids need more area where they are disordered, in 3D: states, modes and evolutions against the
// axisymmetric solver, by all integrators, and the energy law.
#include "surface3d/lipids.h"

#include "axisym/flow.h"
#include "axisym/lipids.h"
#include "axisym/modes/growth_rates.h"
#include "axisym/start_shapes.h"
#include "axisym/stationary/stationary.h"
#include "surface3d/stationary/stationary.h"
#include "surface3d/variational/growth_rates.h"
#include "surface3d/variational/variational_stepper.h"
#include "tests/surface3d/energy_balance.h"
#include "tests/surface3d/stationary/places.h"

#include <algorithm>

namespace sbeh::surface3d {
namespace {

using namespace test;

const Target target = ordered_oblate.target();

// A third more area at β = 0, and a density that is no straight line.
Material expanding() {
  Material material = paper_material(0.05);
  material.lipid_density = model::Polynomial({1 / 1.3, 1.2 * (1 - 1 / 1.3), 0.2});
  return material;
}

axisym::StationaryState axisymmetric(const Material& material) {
  const auto found =
      axisym::solve_stationary(material, Model::SBEH, target, with_axis(ordered_oblate));
  EXPECT_EQ(found.status, axisym::NewtonStatus::converged);
  return found.state;
}

NewtonResult settled(const Material& material, const Surface& start) {
  NewtonSystem system(*start.mesh, material, Model::SBEH);
  NewtonResult found =
      solve_stationary(system, target, guess_from(*start.mesh, material, Model::SBEH, start.state));
  EXPECT_EQ(found.status, NewtonStatus::converged);
  return found;
}

TEST(Lipids3d, have_the_states_and_rates_of_the_axisymmetric_solver) {
  const Material material = expanding();
  const axisym::StationaryState exact = axisymmetric(material);
  const double U = axisym::energy(material, exact, exact.H).total();
  std::vector<double> expected;
  const auto second = axisym::second_variation(material, Model::SBEH, exact);
  for (int m = 0; m <= 4; ++m) {
    const auto rates = axisym::growth_rates({second, material, Model::SBEH}, m, 3);
    ASSERT_TRUE(rates);
    for (const axisym::GrowthMode& mode : *rates)
      for (int copy = 0; copy < (m == 0 ? 1 : 2); ++copy) expected.push_back(mode.rate);
  }
  std::ranges::sort(expected, std::greater{});
  constexpr int count = 5;
  OrderTable energies("energy", "h"), tensions("tension", "h"),
      rates("largest error of rates", "h");
  for (const int triangles : {80, 320, 1280}) {
    const Surface start = revolved(exact, triangles);
    const NewtonResult found = settled(material, start);
    const double h = 1 / std::sqrt(start.mesh->count());
    energies.add(h, energy(material, *start.mesh, found.state).total() - U);
    tensions.add(h, found.state.tension - exact.tension);
    EXPECT_NEAR(lipids_and_volume(*start.mesh, material, found.state).area, target.area, 1e-5);
    const auto modes = growth_rates(material, *start.mesh, Model::SBEH, found.state, count);
    ASSERT_TRUE(modes);
    double worst = 0;
    for (std::size_t k = 0; k < count; ++k)
      worst = std::max(worst, std::abs((*modes)[k].rate / expected[k] - 1));
    rates.add(h, worst);
  }
  EXPECT_GT(energies.print(), 3.5);
  EXPECT_GT(tensions.print(), 3);
  EXPECT_GT(rates.print(), 3);
}

TEST(Lipids3d, have_their_energy_law_to_first_order_in_tau) {
  Material material = expanding();
  material.order_viscosity = -0.6;
  Surface start = ordered_spheroid(0.8, 180);
  const Target kept = lipids_and_volume(*start.mesh, material, start.state);
  // Without the violent first moments.
  start.state = energy_balance_of(material, start, kept, 0.02, 20).end;
  expect_energy_law("lipids", material, start, kept, 8e-3, 8);
}

TEST(Lipids3d, move_as_in_the_axisymmetric_solver) {
  const Material material = expanding();
  const double duration = 0.2;
  axisym::Numerics fine;
  fine.elements = 96;
  fine.tolerance = 1e-6;
  const axisym::State curve{axisym::spheroid(0.8, false, 96, 0.5),
                            axisym::Field::Constant(3 * 96 + 1, model::full_order)};
  const auto exact = axisym::run_flow(material, Model::SBEH, curve, target, fine,
                                      {.end_time = duration, .output_times = {}});
  ASSERT_EQ(exact.stop, FlowStop::end_time);
  const Surface start = ordered_spheroid(0.8, 320);
  const Target kept = lipids_and_volume(*start.mesh, material, start.state);
  for (const Integrator integrator : {Integrator::two_step, Integrator::variational}) {
    Numerics numerics;
    numerics.tolerance = integrator == Integrator::variational ? 1e-3 : 1e-5;
    numerics.integrator = integrator;
    const FlowResult run = run_flow(material, Model::SBEH, start.moment(), numerics,
                                    {.end_time = duration, .output_times = {}});
    ASSERT_EQ(run.stop, FlowStop::end_time);
    const Target now = lipids_and_volume(*start.mesh, material, run.state);
    EXPECT_NEAR(now.area / kept.area, 1, 1e-10) << name(integrator);
    EXPECT_NEAR(now.volume / kept.volume, 1, 1e-10) << name(integrator);
    std::printf("%s: %d steps, U = %.8f, axisymmetric %.8f; area %.6f\n", name(integrator),
                run.steps, run.last.energy.total(), exact.last.energy.total(),
                area(*start.mesh, run.state.X) / (4 * pi));
    EXPECT_NEAR(run.last.energy.total(), exact.last.energy.total(),
                integrator == Integrator::variational ? 1e-2 : 1e-4)
        << name(integrator);
  }
}

TEST(Lipids3d, of_a_sphere_have_nowhere_to_go) {
  EXPECT_THROW(run_flow(expanding(), Model::SBEH, uniform_sphere(model::full_order, 80).moment(),
                        {}, {.end_time = 1, .output_times = {}}),
               std::invalid_argument);
}

// Newton's method begins where the flow ends.
TEST(Lipids3d, come_near_rest_where_newtons_method_does) {
  const Material material = expanding();
  const Surface start = ordered_spheroid(0.8, 80);
  const FlowResult run =
      run_flow(material, Model::SBEH, start.moment(), {}, {.end_time = 40, .output_times = {}});
  const NewtonResult found = settled(material, {start.mesh, run.state});
  // Their curvatures are not the same with so few triangles.
  EXPECT_NEAR(energy_of(*start.mesh, material, run.state),
              energy(material, *start.mesh, found.state).total(), 1e-4);
}

}  // namespace
}  // namespace sbeh::surface3d
