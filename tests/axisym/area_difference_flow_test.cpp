// The flow of a membrane whose leaflets have an area difference: its states of rest, its energy law.
#include "axisym/modes/eigenmodes.h"
#include "axisym/modes/growth_rates.h"
#include "tests/axisym/cases.h"

namespace sbeh::axisym {
namespace {

using namespace test;

constexpr double infinite = std::numeric_limits<double>::infinity();

double W2_of(const State& s) { return diagnose({}, s).W2; }

// κ is 0.1 at full order.
Material with_areas(double stiffness, double W2) {
  Material material = paper_material(0.05);
  material.area_difference = {stiffness, W2};
  return material;
}

State relaxed(Model model, double time) {
  return run_flow(paper_material(0.05), model, ordered_spheroid(0.8, 48), target_of(0.8), {},
                  {.end_time = time, .output_times = {}})
      .state;
}

TEST(AreaDifferenceFlow, comes_to_rest_where_newtons_method_does) {
  for (const Model model : {Model::SBEH, Model::SSH}) {
    const BranchState start = first_oblate(model, 48);
    for (const double stiffness : {0.2, 20., infinite}) {
      const double shift = stiffness == infinite ? 0 : 0.5;
      const Material material = with_areas(stiffness, W2_of(start) + shift);
      State from = start;
      if (shift == 0) {  // another shape of the same W₂: less volume
        from = relaxed(model, 0.05);
      }
      const Material of = shift == 0 ? with_areas(stiffness, W2_of(from)) : material;
      const FlowResult run =
          run_flow(of, model, from, target_of(0.8), {}, {.end_time = 200, .output_times = {}});
      ASSERT_EQ(run.stop, FlowStop::at_rest) << stiffness;
      const NewtonResult found =
          solve_stationary(of, model, target_of(0.8), guess_from(of, model, run.state));
      ASSERT_EQ(found.status, NewtonStatus::converged) << stiffness;
      const Diagnostics flow = diagnose(of, run.state), newton = diagnose(of, found.state);
      std::printf("%s, k_ad = %g: c = %.6f, W2 = %.8f, U = %.9f, of the flow %.2e more\n",
                  name(model), stiffness, found.state.moment, newton.W2, newton.energy.total(),
                  flow.energy.total() - newton.energy.total());
      EXPECT_GT(std::abs(found.state.moment), 1e-3);
      EXPECT_NEAR(flow.energy.total(), newton.energy.total(), 2e-7);
      EXPECT_NEAR(flow.W2, newton.W2, 2e-5);
      EXPECT_LT((run.state.X.row(0) - found.state.X.row(0)).cwiseAbs().maxCoeff(), 3e-3);
    }
  }
}

TEST(AreaDifferenceFlow, has_its_energy_law_to_first_order_in_tau) {
  for (const Model model : {Model::SBEH, Model::SSH, Model::HelfrichLocal, Model::HelfrichGlobal})
    for (const double stiffness : {0.5, infinite}) {
      const State start = relaxed(model, 0.02);
      const Material material =
          with_areas(stiffness, W2_of(start) + (stiffness == infinite ? 0 : 0.3));
      const Target target = target_of(0.8);
      OrderTable table(std::string(name(model)) + ", k_ad = " + std::to_string(stiffness)
                           + ": energy lost against the sum of tau D, relative",
                       "tau");
      for (const int steps : {8, 16, 32, 64}) {
        const auto [excess, end] = energy_balance_of(material, model, start, target, 8e-3, steps);
        table.add(8e-3 / steps, excess);
        if (stiffness == infinite) {
          EXPECT_NEAR(W2_of(end), material.area_difference.W2, 1e-3);
        }
      }
      EXPECT_GT(table.print(), 0.85);  // of SBEH's couple the terms of first order nearly cancel
    }
}

TEST(AreaDifferenceFlow, is_of_second_order_when_extrapolated) {
  const State start = relaxed(Model::SBEH, 0.02);
  for (const double stiffness : {0.5, infinite}) {
    const Material material =
        with_areas(stiffness, W2_of(start) + (stiffness == infinite ? 0 : 0.3));
    const auto end = [&](int steps) {
      Numerics numerics;
      numerics.tolerance = 0.1;
      numerics.first_step = numerics.largest_step = 0.02 / steps;
      return run_flow(material, Model::SBEH, start, target_of(0.8), numerics,
                      {.end_time = 0.02, .output_times = {}, .stop_at_rest = false})
          .last.energy.total();
    };
    OrderTable table("energy at t = 0.02, change from half the step", "tau");
    double before = end(4);
    for (const int steps : {8, 16, 32}) {
      const double now = end(steps);
      table.add(0.02 / steps, now - before);
      before = now;
    }
    EXPECT_NEAR(table.print(), 2, 0.35) << stiffness;
  }
}

TEST(AreaDifferenceFlow, of_a_bilayer_couple_begins_with_its_W2) {
  const State start = relaxed(Model::SSH, 0.02);
  EXPECT_THROW(run_flow(with_areas(infinite, W2_of(start) + 0.1), Model::SSH, start, target_of(0.8),
                        {}, {.end_time = 1, .output_times = {}}),
               std::invalid_argument);
}

// δ²U of m = 0 by the differences of U of states that are held at a displacement; rates by the flow itself.
TEST(AreaDifferenceFlow, decays_with_the_rate_of_its_modes) {
  const BranchState start = first_oblate(Model::SSH, 48);
  for (const double stiffness : {0.5, infinite}) {
    const Material material =
        with_areas(stiffness, W2_of(start) + (stiffness == infinite ? 0 : 0.3));
    const NewtonResult rest = solve_stationary(material, Model::SSH, target_of(0.8),
                                               guess_from(material, Model::SSH, start));
    ASSERT_EQ(rest.status, NewtonStatus::converged);
    const SecondVariation second = second_variation(material, Model::SSH, rest.state);
    const auto rates = growth_rates(LinearFlow(second, material, Model::SSH), 0, 2);
    ASSERT_TRUE(rates);
    const GrowthMode& slowest = rates->front();
    const SecondVariation without = second_variation(paper_material(0.05), Model::SSH, start);
    const auto free = growth_rates(LinearFlow(without, paper_material(0.05), Model::SSH), 0, 2);
    // Displaced along the mode, the flow brings it back so fast.
    State s = rest.state;
    s.X += node_normals(s.X) * Field(1e-3 * slowest.u).asDiagonal();
    ASSERT_TRUE(correct_area_volume(s.X, target_of(0.8).area, target_of(0.8).volume));
    const double rest_energy = energy_of(material, rest.state).total();
    TimeStepper stepper(material, Model::SSH, 48);
    const auto excess_after = [&](int steps, double time) {
      State now = s;
      for (int k = 0; k < steps; ++k) now = stepper.step(now, target_of(0.8), time / steps).state;
      return energy_of(material, now).total() - rest_energy;
    };
    const double time = 0.3 / std::abs(slowest.rate);
    const auto rate = [&](int steps) {
      return std::log(excess_after(2 * steps, 2 * time) / excess_after(steps, time)) / (2 * time);
    };
    const double measured = 2 * rate(40) - rate(20);
    std::printf("k_ad = %g: rate %.6f, without %.6f; measured %.6f\n", stiffness, slowest.rate,
                free->front().rate, measured);
    EXPECT_NEAR(measured, slowest.rate, 0.01 * std::abs(slowest.rate)) << stiffness;
  }
}

}  // namespace
}  // namespace sbeh::axisym
