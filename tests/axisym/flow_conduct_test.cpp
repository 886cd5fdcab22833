// How a run under step control behaves: output times, rejection, interruption, and its reasons to stop.
#include "tests/axisym/cases.h"

#include <stdexcept>

namespace sbeh::axisym {
namespace {

using namespace test;

FlowResult oblate_run(const Numerics& numerics, const FlowSchedule& schedule,
                      const FlowObserver& observe = {}) {
  return run_flow(paper_material(0.05), Model::SBEH, ordered_spheroid(0.7, numerics.elements),
                  target_of(0.7), numerics, schedule, observe);
}

TEST(Flow, meets_output_times_exactly_and_sees_every_step) {
  const std::vector<double> asked{0, 1e-5, 1e-3, 0.00123456789, 0.01, 0.05, 7.};
  std::vector<double> met;
  int seen = 0;
  double last_time = -1;
  const FlowResult run = oblate_run(
      with_elements(24), {.end_time = 0.05, .output_times = asked, .stop_at_rest = false},
      [&](const FlowRecord& record, const State& state, bool exact) {
        EXPECT_GT(record.time, last_time);
        EXPECT_EQ(state.beta.size(), state.X.cols());
        last_time = record.time;
        if (exact) met.push_back(record.time);
        ++seen;
        return true;
      });
  EXPECT_EQ(run.stop, FlowStop::end_time);
  EXPECT_EQ(run.last.time, 0.05);
  EXPECT_EQ(met, (std::vector<double>{0, 1e-5, 1e-3, 0.00123456789, 0.01, 0.05}));
  EXPECT_EQ(seen, run.steps + 1);  // the start too
}

TEST(Flow, takes_output_times_that_differ_by_rounding_for_one) {
  // 0.1 + 0.2 is not 0.3. A step of 5e-17 between the two would move the mesh but not the membrane.
  std::vector<double> asked;
  for (int k = 1; k <= 9; ++k) asked.insert(asked.end(), {k * 1e-3, 0.001 * k + 1e-18 * k});
  asked.insert(asked.end(), {0.01, std::nextafter(0.01, 1)});
  const Numerics numerics = with_elements(24);
  const FlowResult run =
      oblate_run(numerics, {.end_time = std::nextafter(asked.back(), 1), .output_times = asked},
                 [&](const FlowRecord& record, const State&, bool) {
                   const double step = record.time > 0 ? record.time_step : numerics.first_step;
                   EXPECT_GE(step, numerics.smallest_step) << "at t = " << record.time;
                   return true;
                 });
  EXPECT_EQ(run.stop, FlowStop::end_time);
}

TEST(Flow, keeps_area_and_volume_to_rounding) {
  oblate_run(with_elements(24), {.end_time = 0.05, .output_times = {}},
             [](const FlowRecord&, const State& s, bool) {
               EXPECT_NEAR(area(s.X) / (4 * pi), 1, 1e-12);
               EXPECT_NEAR(reduced_volume(area(s.X), volume(s.X)) / 0.7, 1, 3e-12);
               return true;
             });
}

struct Output {
  double energy, error;  // what the tolerance in position is worth in energy: force times it
};
std::vector<Output> history(const Numerics& numerics, const std::vector<double>& times,
                            int& rejected, double& first_accepted) {
  std::vector<Output> outputs;
  first_accepted = 0;
  const FlowResult run =
      oblate_run(numerics, {.end_time = times.back(), .output_times = times, .stop_at_rest = false},
                 [&](const FlowRecord& r, const State&, bool exact) {
                   if (first_accepted == 0) first_accepted = r.time_step;
                   if (exact && r.time > 0)
                     outputs.push_back({r.energy.total(), numerics.tolerance * r.dissipation.total()
                                                              / r.normal_speed});
                   return true;
                 });
  EXPECT_EQ(run.stop, FlowStop::end_time);
  rejected = run.last.rejected;
  return outputs;
}

TEST(Flow, forgets_rejected_steps) {
  const std::vector<double> times{1e-4, 1e-3, 1e-2, 5e-2};
  Numerics fitting = with_elements(24), too_large = fitting;
  too_large.first_step = too_large.largest_step;
  int few, many, as_many;
  double first, accepted, again;
  const auto expected = history(fitting, times, few, first);
  const auto found = history(too_large, times, many, accepted);
  EXPECT_GE(many, few + 3);
  ASSERT_EQ(expected.size(), times.size());
  ASSERT_EQ(found.size(), times.size());
  for (std::size_t k = 0; k < times.size(); ++k) {
    std::printf("t = %g: %.10f against %.10f after rejections, allowed %.1e\n", times[k],
                expected[k].energy, found[k].energy, expected[k].error);
    EXPECT_NEAR(found[k].energy, expected[k].energy, expected[k].error);
  }
  // Begun with the very step that was accepted in the end, the run differs by the length of the next steps alone.
  Numerics at_once = too_large;
  at_once.first_step = accepted;
  const auto same = history(at_once, times, as_many, again);
  ASSERT_EQ(same.size(), times.size());
  EXPECT_EQ(again, accepted);
  EXPECT_LT(as_many, many);
  for (std::size_t k = 0; k < times.size(); ++k)
    EXPECT_NEAR(same[k].energy, found[k].energy, expected[k].error);
}

TEST(Flow, gives_the_same_bits_twice) {
  const FlowSchedule schedule{.end_time = 0.01, .output_times = {0.003}};
  const FlowResult a = oblate_run(with_elements(24), schedule),
                   b = oblate_run(with_elements(24), schedule);
  EXPECT_EQ(a.state.X, b.state.X);
  EXPECT_EQ(a.state.beta, b.state.beta);
  EXPECT_EQ(a.steps, b.steps);
}

TEST(Flow, goes_on_from_an_output_as_if_nothing_had_happened) {
  // A state is a checkpoint: with the step that came next, the continued run takes the same steps.
  const FlowSchedule whole{.end_time = 0.02, .output_times = {0.01}, .stop_at_rest = false};
  State middle;
  double next_step = 0;
  const FlowResult through =
      oblate_run(with_elements(24), whole, [&](const FlowRecord& r, const State& s, bool exact) {
        if (r.time == 0.01 && exact) middle = s;
        if (r.time > 0.01 && next_step == 0) next_step = r.time_step;
        return true;
      });
  ASSERT_GT(next_step, 0);
  Numerics numerics = with_elements(24);
  numerics.first_step = next_step;
  const FlowResult rest =
      run_flow(paper_material(0.05), Model::SBEH, middle, target_of(0.7), numerics,
               {.end_time = 0.01, .output_times = {}, .stop_at_rest = false});
  // Equal but for the rounding of the times.
  EXPECT_NEAR(rest.last.energy.total(), through.last.energy.total(), 1e-11);
}

TEST(Flow, is_interrupted_by_an_observer_that_returns_false) {
  for (const int stop_at : {1, 5}) {
    int seen = 0;
    const FlowResult run =
        oblate_run(with_elements(24), {.end_time = 1, .output_times = {}},
                   [&](const FlowRecord&, const State&, bool) { return ++seen < stop_at; });
    EXPECT_EQ(run.stop, FlowStop::interrupted);
    EXPECT_EQ(seen, stop_at);
    EXPECT_EQ(run.steps, stop_at - 1);
  }
}

TEST(Flow, stops_when_the_step_it_may_take_is_too_large_for_the_tolerance) {
  Numerics numerics = with_elements(24);
  numerics.tolerance = 1e-12;
  numerics.first_step = numerics.smallest_step = numerics.largest_step = 1e-2;
  const FlowResult run = oblate_run(numerics, {.end_time = 1, .output_times = {}});
  EXPECT_EQ(run.stop, FlowStop::step_too_small);
  EXPECT_EQ(run.steps, 0);
}

TEST(Flow, just_before_the_fold_rests_at_the_smooth_oblate) {
  const PlanePoint at{0.6, 0.07};  // the fold is at L = 0.07064
  const Material material = paper_material(at.L);
  const FlowResult run = run_flow(material, Model::SBEH, ordered_spheroid(0.6, 48), target_of(0.6),
                                  {}, {.end_time = 300, .output_times = {}});
  ASSERT_EQ(run.stop, FlowStop::at_rest);
  const BranchState b = oblate(Model::SBEH, at, 48);
  const double expected = energy_of(material, b).total();
  const Diagnostics d = diagnose(material, run.state);
  std::printf("order_min %.6f, energy %.10f (Newton %.10f), at rest at t = %.1f\n", d.order_min,
              run.last.energy.total(), expected, run.last.time);
  EXPECT_NEAR(d.order_min, 0.484, 1e-3);
  EXPECT_NEAR(run.last.energy.total() / expected, 1, 1e-6);
}

TEST(Flow, past_the_fold_ends_with_a_reason_in_bounded_steps) {
  const Material material = paper_material(0.08);
  const FlowResult run = run_flow(material, Model::SBEH, ordered_spheroid(0.6, 48), target_of(0.6),
                                  {}, {.end_time = 300, .output_times = {}});
  const Diagnostics d = diagnose(material, run.state);
  std::printf(
      "%s at t = %.3f after %d steps (%d rejected): |H| %.1f, order_min %.4f, resolution %.3f\n",
      describe(run.stop).c_str(), run.last.time, run.steps, run.last.rejected, d.H_abs_max,
      d.order_min, d.resolution);
  EXPECT_TRUE(run.stop == FlowStop::unresolved || run.stop == FlowStop::step_too_small);
  EXPECT_LT(run.steps, 3000);
  EXPECT_LT(run.last.rejected, 1000);
  EXPECT_GT(d.H_abs_max, 6);  // beyond any smooth state
}

TEST(Numerics, refuse_values_out_of_range) {
  EXPECT_NO_THROW(Numerics{}.validate());
  const auto refused = [](auto member, auto value) {
    Numerics n;
    n.*member = value;
    EXPECT_THROW(n.validate(), std::invalid_argument) << value;
  };
  refused(&Numerics::elements, 7);
  refused(&Numerics::grading, -0.1);
  refused(&Numerics::tolerance, 0.);
  refused(&Numerics::tolerance, std::numeric_limits<double>::quiet_NaN());
  refused(&Numerics::first_step, 0.);
  refused(&Numerics::smallest_step, 0.5);  // above largest_step
  refused(&Numerics::largest_step, 1e-9);  // below first_step
  refused(&Numerics::rest_speed, 0.);
}

}  // namespace
}  // namespace sbeh::axisym
