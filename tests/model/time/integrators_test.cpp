// The integrators alone, on two small equations whose solutions are known.
#include "model/time/flow.h"
#include "model/time/multi_step.h"
#include "tests/order_table.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numeric>
#include <utility>
#include <vector>

namespace sbeh::model {
namespace {

using test::OrderTable;

struct Pair {
  double X = 0, beta = 0;
};

Distance distance_of(const Pair& a, const Pair& b) {
  return {std::abs(b.X - a.X), std::abs(b.beta - a.beta)};
}

/// Ẋ = −X³, β̇ = −Xβ from (1, 1): X = 1/√(1 + 2t), β = e^{1 − √(1 + 2t)}. X loses the energy X⁴/4 at the
/// rate Ẋ².
struct Decay {
  using State = Pair;

  FlowStep<Pair> step(const Pair& old, const std::optional<Target>&, double tau) {
    return step(old, old, tau);
  }
  FlowStep<Pair> step(const Pair& at, const Pair& from, double tau) {
    const Pair next{from.X / (1 + tau * at.X * at.X), from.beta / (1 + tau * at.X)};
    const double speed = (next.X - from.X) / tau;
    return {.fault = FlowFault::none, .state = next, .dissipation = {.friction = speed * speed}};
  }
  bool restore(Pair&, const Target&) const { return true; }
  Distance distance(const Pair& a, const Pair& b) const { return distance_of(a, b); }

  static Pair exact(double t) {
    const double s = std::sqrt(1 + 2 * t);
    return {1 / s, std::exp(1 - s)};
  }
  static double energy(const Pair& s) { return std::pow(s.X, 4) / 4; }
};

/// Ẋ = −β, β̇ = X from (1, 0): the unit circle. A step keeps X² + β², the area, at its target to first
/// order.
struct Rotation {
  using State = Pair;

  // (1 − τJ) next = (1 + μ) from, μ so that to first order it ends at the target
  FlowStep<Pair> step(const Pair& old, const std::optional<Target>& target, double tau) {
    return stretched(target ? 1 + (target->area - area(old)) / 2 : 1, old, tau);
  }
  FlowStep<Pair> step(const Pair&, const Pair& from, double tau) { return stretched(1, from, tau); }
  static FlowStep<Pair> stretched(double stretch, const Pair& from, double tau) {
    const double x = stretch * from.X, b = stretch * from.beta, d = 1 + tau * tau;
    return {.fault = FlowFault::none, .state = {(x - tau * b) / d, (b + tau * x) / d}};
  }
  static double area(const Pair& s) { return s.X * s.X + s.beta * s.beta; }
  bool restore(Pair& s, const Target& target) const {
    const double factor = std::sqrt(target.area / area(s));
    s = {factor * s.X, factor * s.beta};
    return true;
  }
  Distance distance(const Pair& a, const Pair& b) const { return distance_of(a, b); }

  static Pair exact(double t) { return {std::cos(t), std::sin(t)}; }
};

static_assert(TwoStepSolver<Decay> && TwoStepSolver<Rotation>);
static_assert(FlowIntegrator<StepDoubling<Decay>, Pair> && FlowIntegrator<MultiStep<Decay>, Pair>);

constexpr Target unit{1, 0};
constexpr double duration = 1;

// The smaller it is the more a higher order pays.
constexpr TimeControl strict{.tolerance = 1e-9, .largest_step = 1e3};
template <class Problem>
auto two_step(Problem& problem) {
  return MultiStep(problem, unit, strict, 2);
}
template <class Problem>
auto three_step(Problem& problem) {
  return MultiStep(problem, unit, strict, 3);
}

struct Outcome {
  Pair end;
  double dissipated = 0;
  double last_error = 0, last_tau = 0;
};

// Steps whose lengths are repeated: 1, 1, … or 1, 2, 1, 2, …
template <class Problem, class Integrator>
Outcome run(Integrator& integrator, int steps, const std::vector<double>& lengths) {
  double sum = 0;
  for (int k = 0; k < steps; ++k) sum += lengths[k % lengths.size()];
  Outcome result{.end = Problem::exact(0)};
  for (int k = 0; k < steps; ++k) {
    const double tau = duration * lengths[k % lengths.size()] / sum;
    const auto step = integrator.advance(result.end, tau);
    EXPECT_TRUE(step.ok());
    integrator.accept(result.end, step, tau);
    result = {.end = step.state,
              .dissipated = result.dissipated + tau * step.dissipation.total(),
              .last_error = step.error,
              .last_tau = tau};
  }
  return result;
}

const std::vector<double> equal{1}, changing{1, 2};

// The order of the state at the end, as the last of these refinements shows it.
template <class Problem>
double order_of(const char* what, auto&& make_integrator, const std::vector<double>& lengths) {
  OrderTable table(what, "tau");
  for (const int steps : {32, 64, 128, 256, 512}) {
    Problem problem;
    auto integrator = make_integrator(problem);
    const Pair end = run<Problem>(integrator, steps, lengths).end;
    table.add(duration / steps, distance_of(end, Problem::exact(duration)).largest());
  }
  return table.print();
}

// From 256 to 512 steps the next power of τ changes an observed order by about τ.
constexpr double slack = 0.02;

TEST(StepDoubling, is_of_second_order_with_extrapolation_and_of_first_without) {
  const auto doubling = [](auto& problem) { return StepDoubling(problem, unit, true); };
  const auto halves = [](auto& problem) { return StepDoubling(problem, unit, false); };
  EXPECT_NEAR(order_of<Decay>("decay by step doubling", doubling, equal), 2, slack);
  EXPECT_NEAR(order_of<Rotation>("rotation by step doubling", doubling, equal), 2, slack);
  EXPECT_NEAR(order_of<Decay>("decay by two half steps", halves, equal), 1, slack);
}

TEST(MultiStep, of_two_is_of_second_order_with_equal_and_with_changing_steps) {
  const auto two = [](auto& problem) { return two_step(problem); };
  EXPECT_NEAR(order_of<Decay>("decay by two-step, equal steps", two, equal), 2, slack);
  EXPECT_NEAR(order_of<Decay>("decay by two-step, ratios 2 and 1/2", two, changing), 2, slack);
  EXPECT_NEAR(order_of<Rotation>("rotation by two-step, equal steps", two, equal), 2, slack);
}

TEST(MultiStep, of_three_is_of_third_order_with_equal_and_with_changing_steps) {
  const auto three = [](auto& problem) { return three_step(problem); };
  const std::vector<double> gently{1, 1.4};
  EXPECT_NEAR(order_of<Decay>("decay by three steps, equal steps", three, equal), 3, slack);
  EXPECT_NEAR(order_of<Decay>("decay by three steps, ratios 1.4 and 1/1.4", three, gently), 3,
              slack);
  EXPECT_NEAR(order_of<Rotation>("rotation by three steps, equal steps", three, equal), 3, slack);
}

template <class Integrator>
void expect_dissipation_of_second_order(const char* what, auto&& make_integrator) {
  OrderTable table(what, "tau");
  for (const int steps : {32, 64, 128, 256, 512}) {
    Decay problem;
    Integrator integrator = make_integrator(problem);
    const Outcome r = run<Decay>(integrator, steps, equal);
    table.add(duration / steps,
              Decay::energy(Decay::exact(0)) - Decay::energy(r.end) - r.dissipated);
  }
  EXPECT_GT(table.print(), 2 - slack) << what;
}

TEST(Integrators, dissipate_what_the_energy_loses_to_second_order) {
  expect_dissipation_of_second_order<StepDoubling<Decay>>(
      "energy balance of step doubling", [](Decay& d) { return StepDoubling(d, unit, true); });
  expect_dissipation_of_second_order<MultiStep<Decay>>("energy balance of two-step",
                                                       [](Decay& d) { return two_step(d); });
}

// Of a run that has begun: the first steps are of second order.
TEST(MultiStep, of_three_dissipates_what_the_energy_loses_to_third_order) {
  OrderTable table("energy balance of three steps", "tau");
  for (const int steps : {32, 64, 128, 256, 512}) {
    Decay problem;
    const double tau = duration / steps;
    MultiStep integrator = three_step(problem);
    const auto rates = [](double t) { return Dissipation{.friction = std::pow(1 + 2 * t, -3)}; };
    integrator.recall(
        {.past = {{Decay::exact(-tau), tau, rates(0)}, {Decay::exact(-2 * tau), tau, rates(-tau)}},
         .steps = 3});
    const Outcome r = run<Decay>(integrator, steps, equal);
    table.add(tau, Decay::energy(Decay::exact(0)) - Decay::energy(r.end) - r.dissipated);
  }
  EXPECT_GT(table.print(), 3 - 0.05);
}

// β̇ = −25 β explicitly and −60 β implicitly: with steps of 0.1 three steps oscillate and grow, two do not.
struct Stiff : Decay {
  static constexpr double explicit_rate = -25, implicit_rate = -60;
  FlowStep<Pair> step(const Pair& old, const std::optional<Target>&, double tau) {
    return step(old, old, tau);
  }
  FlowStep<Pair> step(const Pair& at, const Pair& from, double tau) {
    auto result = Decay::step(at, from, tau);
    result.state.beta = next(at.beta, from.beta, tau);
    return result;
  }
  static double next(double at, double from, double tau) {
    return (from + tau * explicit_rate * at) / (1 - tau * implicit_rate);
  }
};

TEST(MultiStep, takes_two_steps_where_three_oscillate) {
  const double tau = 0.1;
  const StepWeights w = step_weights({tau, 0, -tau, -2 * tau}, 3);
  std::array<double, 3> x{1, 1, 1};
  for (int k = 0; k < 100; ++k) {
    const auto sum = [&](const auto& weights) {
      return std::inner_product(x.begin(), x.end(), weights.begin(), 0.);
    };
    x = {Stiff::next(sum(w.ahead), sum(w.from), w.tau), x[0], x[1]};
  }
  EXPECT_GT(std::abs(x[0]), 10);  // of the formula of three steps alone

  for (const double largest : {tau, 1e3}) {
    Stiff problem;
    MultiStep integrator(problem, unit, TimeControl{.tolerance = 1e-4, .largest_step = largest}, 3);
    Pair state{0, 1e-5};  // steps whose errors exceed the tolerance would not be accepted
    for (int k = 0; k < 100; ++k) {
      const auto step = integrator.advance(state, tau);
      integrator.accept(state, step, tau);
      state = step.state;
    }
    EXPECT_LT(std::abs(state.beta), 1e-8) << largest;
  }
}

TEST(MultiStep, of_three_reports_the_error_of_the_two_step_formula) {
  Rotation problem;
  const std::vector<double> gently{1, 1.4};
  for (const auto& [lengths, ratio] : {std::pair(equal, 1.), std::pair(gently, 1.4)}) {
    MultiStep integrator = three_step(problem);
    const Outcome r = run<Rotation>(integrator, 512, lengths);
    const double third = distance_of({0, 0}, Rotation::exact(duration)).largest();
    // of x(t_new) by the derivative of the parabola: τ³ (1 + r)² x⃛/(6 r (1 + 2r))
    const double error =
        std::pow(r.last_tau, 3) * std::pow(1 + ratio, 2) / (6 * ratio * (1 + 2 * ratio)) * third;
    EXPECT_NEAR(r.last_error / error, 1, slack);
  }
}

TEST(Integrators, report_a_quarter_of_tau_squared_times_the_acceleration_as_error) {
  Rotation problem;  // linear, so that a step is that of the implicit Euler method
  const auto expect_quarter = [](auto integrator) {
    const Outcome r = run<Rotation>(integrator, 512, equal);
    const double acceleration = distance_of({0, 0}, Rotation::exact(duration)).largest();
    EXPECT_NEAR(r.last_error / (r.last_tau * r.last_tau * acceleration / 4), 1, slack);
  };
  expect_quarter(StepDoubling(problem, unit, true));
  expect_quarter(two_step(problem));
}

TEST(Integrators, keep_the_area_to_rounding) {
  Rotation problem;
  const auto expect_kept = [&](auto integrator) {
    const Outcome r = run<Rotation>(integrator, 20, equal);
    EXPECT_NEAR(problem.area(r.end), 1, 1e-14);
  };
  expect_kept(StepDoubling(problem, unit, true));
  expect_kept(StepDoubling(problem, unit, false));
  expect_kept(two_step(problem));
  expect_kept(three_step(problem));
}

TEST(MultiStep, that_forgets_steps_as_from_a_start_and_one_that_recalls_as_before) {
  Decay problem;
  for (const int most : {2, 3}) {
    MultiStep integrator(problem, unit, strict, most), other(problem, unit, strict, most);
    Pair state = Decay::exact(0);
    const double tau = 0.1;
    for (int k = 0; k < 4; ++k) {
      const auto step = integrator.advance(state, tau);
      integrator.accept(state, step, tau);
      state = step.state;
      other.recall(integrator.history());
      EXPECT_EQ(other.advance(state, tau).state.X, integrator.advance(state, tau).state.X);
    }
    integrator.forget();
    EXPECT_EQ(integrator.advance(state, tau).state.X,
              StepDoubling(problem, unit, true).advance(state, tau).state.X);
  }
}

// A solver whose step or restoration fails.
struct Failing : Decay {
  FlowFault fault = FlowFault::none;
  bool restores = true;
  double error = 0;
  FlowStep<Pair> step(const Pair& old, const std::optional<Target>&, double tau) {
    return step(old, old, tau);
  }
  FlowStep<Pair> step(const Pair& at, const Pair& from, double tau) {
    auto result = Decay::step(at, from, tau);
    result.fault = fault;
    return result;
  }
  bool restore(Pair&, const Target&) const { return restores; }
  Distance distance(const Pair&, const Pair&) const { return {error, 0}; }
};

TEST(Integrators, say_what_was_wrong_with_a_step) {
  const auto fault_of = [](Failing problem) {
    MultiStep integrator = two_step(problem);
    const FlowFault at_first = integrator.advance(Decay::exact(0), 0.1).fault;
    integrator.recall({.past = {{Decay::exact(0), 0.1, {}}}});
    EXPECT_EQ(integrator.advance(Decay::exact(0.1), 0.1).fault, at_first);
    return at_first;
  };
  Failing unsolved, lost, wild;
  unsolved.fault = FlowFault::linear_solve;
  lost.restores = false;
  wild.error = std::nan("");
  EXPECT_EQ(fault_of({}), FlowFault::none);
  EXPECT_EQ(fault_of(unsolved), FlowFault::linear_solve);
  EXPECT_EQ(fault_of(lost), FlowFault::area_volume);
  EXPECT_EQ(fault_of(wild), FlowFault::degenerate);
}

}  // namespace
}  // namespace sbeh::model
