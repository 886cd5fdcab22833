// Membranes whose lipids need more area where they are disordered: n dS is kept, not dS.
#include "axisym/lipids.h"

#include "axisym/modes/growth_rates.h"
#include "axisym/stationary/stability.h"
#include "tests/axisym/cases.h"

namespace sbeh::axisym {
namespace {

using namespace test;

// A third more area at β = 0, and a density that is no straight line.
Material expanding(double L) {
  Material material = paper_material(L);
  material.lipid_density = model::Polynomial({1 / 1.3, 1.2 * (1 - 1 / 1.3), 0.2});
  return material;
}

State moving(double V_r, const Material& material, double time) {
  return run_flow(material, Model::SBEH, ordered_spheroid(V_r, 48), target_of(V_r), {},
                  {.end_time = time, .output_times = {}})
      .state;
}

TEST(Lipids, are_kept_in_number_not_in_area) {
  const Material material = expanding(0.07);
  const State start = ordered_spheroid(0.7, 48), end = moving(0.7, material, 0.3);
  EXPECT_NEAR(lipid_area(material, end) / lipid_area(material, start), 1, 1e-11);
  EXPECT_NEAR(volume(end.X) / volume(start.X), 1, 1e-11);
  EXPECT_GT(area(end.X), 1.01 * area(start.X));
}

TEST(Lipids, have_their_energy_law_to_first_order_in_tau) {
  for (const double xi : {0., -0.6}) {
    Material material = expanding(0.05);
    material.order_viscosity = xi;
    const State start = moving(0.8, material, 0.02);
    const Target target{lipid_area(material, start), volume(start.X)};
    OrderTable table("energy lost against the sum of tau D, relative", "tau");
    for (const int steps : {8, 16, 32, 64})
      table.add(8e-3 / steps,
                energy_balance_of(material, Model::SBEH, start, target, 8e-3, steps).excess);
    EXPECT_NEAR(table.print(), 1, 0.15);
  }
}

TEST(Lipids, come_to_rest_where_newtons_method_does) {
  const Material material = expanding(0.05);
  const FlowResult run = run_flow(material, Model::SBEH, ordered_spheroid(0.8, 48), target_of(0.8),
                                  {}, {.end_time = 400, .output_times = {}});
  ASSERT_EQ(run.stop, FlowStop::at_rest);
  const NewtonResult found = solve_stationary(material, Model::SBEH, target_of(0.8),
                                              guess_from(material, Model::SBEH, run.state));
  ASSERT_EQ(found.status, NewtonStatus::converged);
  EXPECT_NEAR(lipid_area(material, found.state), 4 * pi, 1e-11);
  EXPECT_LT(residual_of(material, Model::SBEH, found.state), 1e-8);
  EXPECT_EQ(negative_directions(material, Model::SBEH, found.state), 0);
  std::printf("U = %.10f, of the flow %.2e more; area %.6f\n",
              energy_of(material, found.state).total(),
              energy_of(material, run.state).total() - energy_of(material, found.state).total(),
              area(found.state.X) / (4 * pi));
  EXPECT_NEAR(energy_of(material, run.state).total(), energy_of(material, found.state).total(),
              1e-6);
}

// Σ is what fewer lipids cost.
TEST(Lipids, cost_the_tension) {
  const Material material = expanding(0.05);
  const BranchState near = first_oblate(Model::SBEH, 48);
  const auto at = [&](double lipids) {
    const Target target{4 * pi * lipids, target_of(0.8).volume};
    const NewtonResult found = solve_stationary(material, Model::SBEH, target, near);
    EXPECT_EQ(found.status, NewtonStatus::converged);
    return found.state;
  };
  constexpr double h = 1e-4;
  const double slope =
      (energy_of(material, at(1 + h)).total() - energy_of(material, at(1 - h)).total())
      / (8 * pi * h);
  EXPECT_NEAR(slope, -at(1).tension, 1e-6);
}

TEST(Lipids, converge_with_the_elements) {
  const Material material = expanding(0.05);
  OrderTable table("energy of the oblate at (0.8, 0.05)", "h");
  const auto energy_at = [&](int elements) {
    const NewtonResult found = solve_stationary(material, Model::SBEH, target_of(0.8),
                                                first_oblate(Model::SBEH, elements));
    EXPECT_EQ(found.status, NewtonStatus::converged);
    return energy_of(material, found.state).total();
  };
  const double fine = energy_at(192);
  for (const int elements : {24, 48, 96}) table.add(1. / elements, energy_at(elements) - fine);
  EXPECT_GT(table.print(), 5);
}

TEST(Lipids, decay_with_the_rate_of_their_modes) {
  const Material material = expanding(0.05);
  const NewtonResult rest =
      solve_stationary(material, Model::SBEH, target_of(0.8), first_oblate(Model::SBEH, 48));
  ASSERT_EQ(rest.status, NewtonStatus::converged);
  const SecondVariation second = second_variation(material, Model::SBEH, rest.state);
  const auto rates = growth_rates(LinearFlow(second, material, Model::SBEH), 0, 2);
  ASSERT_TRUE(rates);
  const GrowthMode& slowest = rates->front();
  State s = rest.state;
  s.X += node_normals(s.X) * Field(1e-3 * slowest.u).asDiagonal();
  s.beta += 1e-3 * slowest.b;
  const Target target = target_of(0.8);
  ASSERT_TRUE(correct_lipids_volume(material, target, s));
  const double rest_energy = energy_of(material, rest.state).total();
  TimeStepper stepper(material, Model::SBEH, 48);
  const auto excess_after = [&](int steps, double time) {
    State now = s;
    for (int k = 0; k < steps; ++k) now = stepper.step(now, target, time / steps).state;
    return energy_of(material, now).total() - rest_energy;
  };
  const double time = 0.3 / std::abs(slowest.rate);
  const auto rate = [&](int steps) {
    return std::log(excess_after(2 * steps, 2 * time) / excess_after(steps, time)) / (2 * time);
  };
  const double measured = 2 * rate(40) - rate(20);
  std::printf("rate %.6f, measured %.6f\n", slowest.rate, measured);
  EXPECT_NEAR(measured, slowest.rate, 0.02 * std::abs(slowest.rate));
}

TEST(Lipids, are_nothing_to_a_uniform_order) {
  const BranchState rest = first_oblate(Model::SSH);
  const NewtonResult found = solve_stationary(expanding(0.05), Model::SSH, target_of(0.8), rest);
  ASSERT_EQ(found.status, NewtonStatus::converged);
  EXPECT_NEAR(area(found.state.X), 4 * pi, 1e-11);
}

TEST(Lipids, of_a_sphere_have_nowhere_to_go) {
  EXPECT_THROW(run_flow(expanding(0.05), Model::SBEH, ordered_spheroid(1, 48), target_of(1), {},
                        {.end_time = 1, .output_times = {}}),
               std::invalid_argument);
}

}  // namespace
}  // namespace sbeh::axisym
