// Step control and schedule alone, and the run of a toy that they steer: no physics.
#include "model/time/flow.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace sbeh::model {
namespace {

constexpr double unlimited = std::numeric_limits<double>::infinity();
constexpr Energy high{.bending = 2}, low{.bending = 1};

// ---- step control -------------------------------------------------------------------------------

const TimeControl control{
    .tolerance = 1e-4, .first_step = 1e-3, .smallest_step = 1e-8, .largest_step = 0.1};

StepControl at(double tau) { return {control, unlimited, tau}; }

double after_rejection(FlowFault fault, double error, int error_order = 2) {
  StepControl steps = at(1e-2);
  EXPECT_TRUE(steps.reject({1e-2, false}, fault, error, error_order));
  return steps.tau() / 1e-2;
}
double after_acceptance(double error, double largest_growth = unlimited, int error_order = 2) {
  StepControl steps(control, largest_growth, 1e-2);
  steps.accept({1e-2, false}, error, error_order);
  return steps.tau() / 1e-2;
}

TEST(StepControl, begins_with_the_first_step_and_goes_on_with_the_one_it_is_given) {
  EXPECT_EQ(at(0).tau(), control.first_step);
  EXPECT_EQ(at(1e-2).tau(), 1e-2);
}

TEST(StepControl, shortens_a_rejected_step_by_what_its_error_asks_for_within_limits) {
  EXPECT_NEAR(after_rejection(FlowFault::error, 9e-4), 0.3, 1e-12);      // 0.9 √(1/9)
  EXPECT_NEAR(after_rejection(FlowFault::error, 27e-4, 3), 0.3, 1e-12);  // 0.9 ∛(1/27)
  EXPECT_NEAR(after_rejection(FlowFault::error, 1.01e-4), 0.5, 1e-12);
  EXPECT_NEAR(after_rejection(FlowFault::error, 1), 0.1, 1e-12);
  EXPECT_NEAR(after_rejection(FlowFault::linear_solve, 0), 0.1, 1e-12);
  EXPECT_NEAR(after_rejection(FlowFault::energy_rises, 1e-5), 0.1, 1e-12);
}

TEST(StepControl, gives_up_below_the_smallest_step) {
  StepControl steps = at(1e-7);
  EXPECT_TRUE(steps.reject({steps.tau(), false}, FlowFault::error, 2e-4, 2));
  EXPECT_FALSE(steps.reject({steps.tau(), false}, FlowFault::degenerate, 0, 2));
}

TEST(StepControl, changes_an_accepted_step_by_what_its_error_allows_within_limits) {
  EXPECT_NEAR(after_acceptance(0.81e-4), 1, 1e-12);
  EXPECT_NEAR(after_acceptance(0.36e-4), 1.5, 1e-12);
  EXPECT_NEAR(after_acceptance(0.216e-4, unlimited, 3), 1.5, 1e-12);
  EXPECT_NEAR(after_acceptance(0), 2, 1e-12);
  EXPECT_NEAR(after_acceptance(0, 1.2), 1.2, 1e-12);  // of the integrator
  EXPECT_NEAR(after_acceptance(1), 0.3, 1e-12);
  StepControl steps = at(0.09);
  steps.accept({0.09, false}, 0, 2);
  EXPECT_EQ(steps.tau(), control.largest_step);
}

TEST(StepControl, lets_the_step_after_a_rejected_one_be_no_longer) {
  StepControl steps = at(1e-2);
  EXPECT_TRUE(steps.reject({1e-2, false}, FlowFault::error, 9e-4, 2));
  const double tau = steps.tau();
  steps.accept({tau, false}, 0, 2);
  EXPECT_EQ(steps.tau(), tau);
  steps.accept({tau, false}, 0, 2);
  EXPECT_EQ(steps.tau(), 2 * tau);
}

TEST(StepControl, is_not_made_timid_by_a_step_cut_short) {
  StepControl steps = at(1e-2);
  const Trial cut = steps.trial(1e-5);
  EXPECT_TRUE(cut.exact);
  EXPECT_EQ(cut.tau, 1e-5);
  steps.accept(cut, 1e-12, 2);
  EXPECT_EQ(steps.tau(), 1e-2);
}

TEST(StepControl, leaves_no_tiny_rest_before_a_stop) {
  EXPECT_EQ(at(1e-2).trial(1).tau, 1e-2);
  EXPECT_FALSE(at(1e-2).trial(1.1e-2).exact);
  EXPECT_EQ(at(1e-2).trial(1.1e-2).tau, 0.55e-2);  // two equal steps
  EXPECT_TRUE(at(1e-2).trial(1e-2 * (1 + 1e-12)).exact);
}

TEST(StepControl, begins_anew_with_no_more_than_the_first_step) {
  StepControl large = at(1e-2), small = at(1e-6);
  large.restart();
  small.restart();
  EXPECT_EQ(large.tau(), control.first_step);
  EXPECT_EQ(small.tau(), 1e-6);
}

TEST(StepControl, rejects_errors_above_the_tolerance_and_rises_of_the_energy_that_the_step_made) {
  const StepControl steps = at(0);
  EXPECT_EQ(steps.judge(1e-4, high, low), FlowFault::none);
  EXPECT_EQ(steps.judge(1.01e-4, high, low), FlowFault::error);
  EXPECT_EQ(steps.judge(std::nan(""), high, low), FlowFault::error);
  EXPECT_EQ(steps.judge(1e-5, low, high), FlowFault::energy_rises);
  EXPECT_EQ(steps.judge(1e-7, low, high), FlowFault::none);  // not of the step
  EXPECT_EQ(steps.judge(1e-5, low, {.bending = 1 + 1e-11}), FlowFault::none);
  EXPECT_EQ(steps.judge(1e-5, low, {.bending = std::nan("")}), FlowFault::energy_rises);
}

// ---- schedule -----------------------------------------------------------------------------------

TEST(Stops, are_the_output_times_and_the_end_once_each) {
  Stops stops({.end_time = 0.3, .output_times = {0.3 + 1e-17, 0.1, 0, 0.1 + 1e-17, 0.2}}, 0);
  EXPECT_TRUE(stops.begin_at_one());
  for (const double expected : {0.1, 0.2, 0.3}) {
    EXPECT_EQ(stops.next(), expected);
    stops.pass();
  }
}

TEST(Stops, of_a_run_that_goes_on_are_those_ahead) {
  const Stops stops({.end_time = 1, .output_times = {0.1, 0.2, 0.3}}, 0.2);
  EXPECT_EQ(stops.next(), 0.3);
  EXPECT_FALSE(Stops({.end_time = 1, .output_times = {}}, 0).begin_at_one());
}

// ---- a run --------------------------------------------------------------------------------------

struct Toy {
  double X = 0, beta = 0;
};

/// X runs down from 1 at the speed `speed(t)`, and is the energy. A step has the error τ² and may fail.
struct ToyWorld {
  using State = Toy;
  static constexpr double largest_growth = unlimited;

  double speed = 1;
  double speed_at_rest = 1e-6;
  std::optional<double> new_mesh_below, obstacle_below;  // in X
  double new_mesh_adds = 0;                              // to X
  bool negligible_errors = false;
  int failures = 0;  // of the steps to come
  int forgotten = 0;
  std::vector<double> tried;  // τ of all steps

  Distance distance(const Toy& a, const Toy& b) const { return {std::abs(b.X - a.X), 0}; }
  Energy energy(const Toy& s) const { return {.bending = s.X}; }
  bool renew(Toy& s) {
    if (!new_mesh_below || s.X > *new_mesh_below) return false;
    new_mesh_below.reset();
    s.X += new_mesh_adds;
    return true;
  }
  std::optional<FlowStop> obstacle(const Toy& s) const {
    if (obstacle_below && s.X < *obstacle_below) return FlowStop::self_contact;
    return {};
  }

  FlowStep<Toy> advance(const Toy& old, double tau) {
    tried.push_back(tau);
    if (failures > 0) return --failures, FlowStep<Toy>{.fault = FlowFault::degenerate};
    return {.fault = FlowFault::none,
            .state = {old.X - speed * tau, old.beta},
            .dissipation = {.friction = speed},
            .error = negligible_errors ? 0 : tau * tau};
  }
  void accept(const Toy&, const FlowStep<Toy>&, double) {}
  void forget() { ++forgotten; }

  FlowResult<Toy> run(const FlowSchedule& schedule, const FlowObserver<Toy>& observe = {},
                      const Toy& start = {.X = 1}, const FlowRecord& from = {}) {
    return Flow(*this, *this, control, speed_at_rest).run(start, from, schedule, observe);
  }
};
static_assert(FlowSolver<ToyWorld> && FlowIntegrator<ToyWorld, Toy>);

TEST(Run, meets_the_output_times_exactly_and_grows_to_what_the_tolerance_allows) {
  const std::vector<double> asked{0, 1e-5, 0.1, 0.123456789, 0.5};
  ToyWorld toy;
  std::vector<double> met;
  double longest = 0;
  const auto result = toy.run({.end_time = 0.5, .output_times = asked},
                              [&](const FlowRecord& r, auto&, bool exact) {
                                if (exact) met.push_back(r.time);
                                longest = std::max(longest, r.time_step);
                                if (r.time_step > 0) {
                                  EXPECT_NEAR(r.energy_balance, 1, 1e-9);
                                }
                                return true;
                              });
  EXPECT_EQ(met, asked);
  EXPECT_EQ(result.stop, FlowStop::end_time);
  EXPECT_EQ(result.last.time, 0.5);
  EXPECT_EQ(result.last.rejected, 0);
  EXPECT_NEAR(result.state.X, 0.5, 1e-12);
  EXPECT_LE(longest, std::sqrt(control.tolerance));
  EXPECT_GT(longest, 0.8 * std::sqrt(control.tolerance));
}

TEST(Run, counts_rejected_steps_and_leaves_no_other_trace_of_them) {
  ToyWorld toy;
  toy.failures = 2;
  int seen = 0;
  const auto result = toy.run({.end_time = 0.01, .output_times = {}},
                              [&](auto&, auto&, bool) { return ++seen, true; });
  EXPECT_EQ(seen, result.steps + 1);
  EXPECT_EQ(int(toy.tried.size()), result.steps + 2);
  EXPECT_EQ(result.last.rejected, 2);
  EXPECT_NEAR(toy.tried[2], 0.01 * control.first_step, 1e-18);
  EXPECT_NEAR(result.state.X, 1 - 0.01, 1e-12);
  EXPECT_EQ(result.fault, FlowFault::none);
}

TEST(Run, ends_with_the_reason_when_no_step_is_small_enough) {
  ToyWorld toy;
  toy.failures = 1000;
  const auto result = toy.run({});
  EXPECT_EQ(result.stop, FlowStop::step_too_small);
  EXPECT_EQ(result.fault, FlowFault::degenerate);
  EXPECT_EQ(result.steps, 0);
  EXPECT_GE(toy.tried.back(), control.smallest_step);
}

TEST(Run, ends_at_rest_unless_told_to_go_on) {
  ToyWorld toy;
  toy.speed = toy.speed_at_rest / 2;
  const auto rest = toy.run({.end_time = 1});
  EXPECT_EQ(rest.stop, FlowStop::at_rest);
  EXPECT_EQ(rest.last.ends, FlowStop::at_rest);
  EXPECT_EQ(rest.steps, 1);
  EXPECT_EQ(toy.run({.end_time = 1, .stop_at_rest = false}).stop, FlowStop::end_time);
}

TEST(Run, adds_up_what_steps_add_to_the_energy_but_not_what_new_meshes_do) {
  ToyWorld toy;  // stands still, rises from 0.02 to 0.06, falls, and gets a new mesh at 0.09
  toy.speed = 0;
  toy.negligible_errors = true;
  toy.new_mesh_adds = 5;
  std::vector<double> hundredths;
  for (int k = 1; k <= 10; ++k) hundredths.push_back(k / 100.);
  const auto result = toy.run({.end_time = 0.1, .output_times = hundredths, .stop_at_rest = false},
                              [&](const FlowRecord& r, const Toy&, bool) {
                                if (r.time < 0.02) {
                                  EXPECT_EQ(r.rises.sum, 0);
                                }
                                toy.speed = r.time < 0.02 ? 0 : r.time < 0.06 ? -1 : 1;
                                if (r.time == 0.08) toy.new_mesh_below = 2;
                                return true;
                              });
  EXPECT_EQ(result.stop, FlowStop::end_time);
  EXPECT_GT(result.last.energy.total(), 5);
  EXPECT_NEAR(result.last.rises.sum, 0.04, 1e-12);
  EXPECT_EQ(result.last.rises.from, 0.02);
  EXPECT_NEAR(result.last.rises.to, 0.06, 1e-12);
}

TEST(Rises, go_too_far_when_they_are_more_than_1e_5_of_the_elastic_energy) {
  FlowRecord last;
  last.energy = {.distortion = 0.5, .bending = 1.5, .thermotropic = -12};
  for (const double sum : {0., 1e-9, 1.9e-5}) {
    last.rises.sum = sum;
    EXPECT_FALSE(rises_too_far(last)) << sum;
  }
  for (const double sum : {2.1e-5, 8e-5, 1.}) {
    last.rises.sum = sum;
    EXPECT_TRUE(rises_too_far(last)) << sum;
  }
}

TEST(Run, ends_at_an_obstacle) {
  ToyWorld toy;
  toy.obstacle_below = 0.9;
  const auto result = toy.run({.end_time = 1});
  EXPECT_EQ(result.stop, FlowStop::self_contact);
  EXPECT_LT(result.state.X, 0.9);
  EXPECT_LT(result.last.time, 0.2);
}

TEST(Run, begins_anew_on_a_new_mesh) {
  ToyWorld toy;
  toy.new_mesh_below = 0.9;
  bool renewed = false;
  toy.run({.end_time = 0.3}, [&](const FlowRecord& r, const Toy&, bool) {
    if (toy.forgotten == 1 && !renewed) {
      EXPECT_EQ(r.next_step, control.first_step);
    }
    renewed = toy.forgotten == 1;
    return true;
  });
  EXPECT_TRUE(renewed);
  EXPECT_EQ(toy.forgotten, 1);
}

TEST(Run, that_goes_on_from_a_record_takes_the_same_steps_and_does_not_show_its_start_again) {
  const FlowSchedule schedule{.end_time = 0.2, .output_times = {0.1}};
  ToyWorld whole, part;
  FlowRecord record;
  Toy middle;
  std::size_t steps_before = 0;
  whole.run(schedule, [&](const FlowRecord& r, const Toy& s, bool exact) {
    if (exact && r.time == 0.1) record = r, middle = s, steps_before = whole.tried.size();
    return true;
  });
  const auto observe = [](const FlowRecord& r, const Toy&, bool) {
    EXPECT_GT(r.time, 0.1);
    return true;
  };
  part.run(schedule, observe, middle, record);
  EXPECT_EQ(part.tried, std::vector(whole.tried.begin() + long(steps_before), whole.tried.end()));
}

TEST(Run, is_interrupted_by_an_observer_that_returns_false) {
  for (const int stop_at : {1, 5}) {
    ToyWorld toy;
    int seen = 0;
    const auto result = toy.run({}, [&](auto&, auto&, bool) { return ++seen < stop_at; });
    EXPECT_EQ(result.stop, FlowStop::interrupted);
    EXPECT_EQ(result.steps, stop_at - 1);
  }
}

}  // namespace
}  // namespace sbeh::model
