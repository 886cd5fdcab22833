// dU/dt = −dissipation: per step, over whole runs, and how well a history of the energy is resolved.
#include "tests/axisym/cases.h"

namespace sbeh::axisym {
namespace {

using namespace test;

// A mildly relaxed oblate at (0.8, 0.05): the kinks of the start are gone, it still moves.
State relaxed(const Material& material, Model model, double time) {
  return run_flow(material, model, ordered_spheroid(0.8, 48), target_of(0.8), {},
                  {.end_time = time, .output_times = {}})
      .state;
}

TEST(EnergyLaw, holds_per_step_to_first_order_in_tau) {
  const Material material = paper_material(0.05);
  const Target target = target_of(0.8);
  for (const Model model : {Model::SBEH, Model::SSH, Model::HelfrichLocal, Model::HelfrichGlobal}) {
    const State start = relaxed(material, model, 0.02);
    TimeStepper stepper(material, model, element_count(start.X));
    OrderTable first(std::string(name(model)) + ": (U_old - U_new)/(tau D) - 1, first step", "tau"),
        whole("  energy lost until t = 0.008 against the sum of tau D, relative", "tau");
    for (const int steps : {8, 16, 32, 64}) {
      const double tau = 8e-3 / steps;
      State s = start;
      const double begin = energy_of(material, s).total();
      double before = begin, spent = 0;
      std::printf("tau = %.3e, ratios:", tau);
      for (int k = 0; k < steps; ++k) {
        const FlowStep r = stepper.step(s, target, tau);
        ASSERT_TRUE(r.ok());
        const double after = energy_of(material, r.state).total();
        EXPECT_LT(after, before);
        const double ratio = (before - after) / (tau * r.dissipation.total());
        if (k % (steps / 8) == 0) std::printf(" %.4f", ratio);
        if (k == 0) first.add(tau, ratio - 1);
        spent += tau * r.dissipation.total();
        before = after;
        s = r.state;
      }
      std::printf("\n");
      whole.add(tau, (begin - before) / spent - 1);
    }
    EXPECT_NEAR(first.print(), 1, 0.1);
    EXPECT_NEAR(whole.print(), 1, 0.1);
  }
}

TEST(EnergyLaw, gives_the_first_dissipation_of_the_spheroid) {
  // V_r = 0.7, L = 0.05 at t = 0: about 2500.
  const Material material = paper_material(0.05);
  const State start = ordered_spheroid(0.7, 48);
  TimeStepper stepper(material, Model::SBEH, 48);
  for (const double tau : {1e-7, 1e-8}) {
    const FlowStep r = stepper.step(start, target_of(0.7), tau);
    ASSERT_TRUE(r.ok());
    std::printf("tau = %.0e: dissipation %.1f (friction %.1f, viscous %.1f, order %.3f)\n", tau,
                r.dissipation.total(), r.dissipation.friction, r.dissipation.viscous,
                r.dissipation.order);
    EXPECT_NEAR(r.dissipation.total(), 2500, 50);
  }
}

// ---- a history in the limit of small steps ------------------------------------------------------
//
// Accepted steps of a controlled run form a sequence; dividing every one of them into 2^k equal parts
// gives runs whose error is an expansion in powers of the step with the same coefficients, so that
// differences show the order and Richardson's extrapolation is sound. (Runs at three tolerances are
// no such family: rejections and cuts at output times differ from run to run.)

const std::vector<double> output_times{1e-3, 2e-3, 5e-3, 1e-2, 2e-2, 5e-2, 0.1, 0.2, 0.5, 1.};

struct Problem {
  Material material;
  Model model;
  State start;
  Target target;
};

// The accepted steps of a run under step control, outputs met.
std::vector<double> accepted_steps(const Problem& p) {
  std::vector<double> steps;
  const FlowResult run = run_flow(
      p.material, p.model, p.start, p.target, {},
      {.end_time = output_times.back(), .output_times = output_times, .stop_at_rest = false},
      [&](const FlowRecord& record, const State&, bool) {
        if (record.time_step > 0) steps.push_back(record.time_step);
        return true;
      });
  EXPECT_EQ(run.stop, FlowStop::end_time);
  return steps;
}

// Energies at the output times with every step divided into `parts`.
std::vector<double> divided_run(const Problem& p, const std::vector<double>& steps, int parts) {
  State s = p.start;
  double time = 0;
  std::vector<double> energies;
  for (const double step : steps) {
    Numerics numerics;
    numerics.tolerance = 0.1;  // every part is accepted
    numerics.first_step = numerics.largest_step = step / parts;
    const FlowResult run = run_flow(p.material, p.model, s, p.target, numerics,
                                    {.end_time = step, .output_times = {}, .stop_at_rest = false});
    EXPECT_EQ(run.stop, FlowStop::end_time);
    EXPECT_EQ(run.last.rejected, 0);
    s = run.state;
    time += step;
    if (energies.size() < output_times.size()
        && std::abs(time / output_times[energies.size()] - 1) < 1e-9)
      energies.push_back(run.last.energy.total());
  }
  return energies;
}

TEST(EnergyHistory, extrapolated_in_tau_is_stable_to_1e_6_at_every_output_time) {
  const Problem p{paper_material(0.05), Model::SBEH, ordered_spheroid(0.7, 48), target_of(0.7)};
  const auto steps = accepted_steps(p);
  const auto one = divided_run(p, steps, 1), two = divided_run(p, steps, 2),
             four = divided_run(p, steps, 4);
  for (const auto* energies : {&one, &two, &four}) ASSERT_EQ(energies->size(), output_times.size());
  std::printf(
      "%zu steps; t, energy, change from whole to halved steps, to quartered, their ratio, "
      "change of the extrapolated energy\n",
      steps.size());
  double first = 0, second = 0;
  for (std::size_t k = 0; k < output_times.size(); ++k) {
    const double coarse = (4 * two[k] - one[k]) / 3, fine = (4 * four[k] - two[k]) / 3;
    const double d1 = two[k] - one[k], d2 = four[k] - two[k];
    std::printf("  %-6g %.10f %10.2e %10.2e %6.2f %10.2e\n", output_times[k], fine, d1, d2, d1 / d2,
                fine - coarse);
    EXPECT_LT(std::abs(fine - coarse), 1e-6 * std::abs(fine)) << "t = " << output_times[k];
    first = std::max(first, std::abs(d1));
    second = std::max(second, std::abs(d2));
  }
  // Second order: the changes fall by four.
  EXPECT_GT(std::log2(first / second), 1.7);
}

// ---- whole runs ---------------------------------------------------------------------------------

TEST(EnergyHistory, falls_monotonically_to_rest_at_the_corners_of_the_paper_s_grid) {
  for (const Model model : {Model::SBEH, Model::SSH})
    for (const double v : {0.6, 0.8})
      for (const double L : {0.01, 0.07}) {
        const Material material = paper_material(L);
        double before = std::numeric_limits<double>::infinity(), largest_rise = 0;
        const FlowResult run = run_flow(material, model, ordered_spheroid(v, 48), target_of(v), {},
                                        {.end_time = 300, .output_times = {}},
                                        [&](const FlowRecord& record, const State&, bool) {
                                          const double now = record.energy.total();
                                          largest_rise = std::max(largest_rise, now - before);
                                          before = now;
                                          return true;
                                        });
        std::printf("%-4s V_r %.1f L %.2f: U = %.9f, %s at t = %.2f, %d steps, %d rejected\n",
                    name(model), v, L, run.last.energy.total(), describe(run.stop).c_str(),
                    run.last.time, run.steps, run.last.rejected);
        EXPECT_EQ(run.stop, FlowStop::at_rest);
        EXPECT_LT(largest_rise, 1e-10 * std::abs(before));  // rounding of the sums
        EXPECT_LT(run.steps, 2000);
      }
}

}  // namespace
}  // namespace sbeh::axisym
