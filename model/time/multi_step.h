// Backward differentiation formulas of two and three steps: second and third order in τ for one solve a step.
#pragma once

#include "model/time/step_control.h"
#include "model/time/step_doubling.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace sbeh::model {

/// A state before a step, and that step.
template <class State>
struct Past {
  State state;
  double tau;
  Dissipation dissipation;  ///< rates at its end
};

/// What a run remembers of its steps.
template <class State>
struct StepHistory {
  std::vector<Past<State>> past;  ///< the last step first; two at most
  int steps = 2;                  ///< of the formula of the next step, if it has as many
};

/// A solver that steps from one state with the coefficients of another, whose area and volume it keeps.
template <class S>
concept TwoStepSolver = OneStepSolver<S> && requires(S solver, const typename S::State& at,
                                                     const typename S::State& from, double tau) {
  { solver.step(at, from, tau) } -> std::same_as<FlowStep<typename S::State>>;
};

/// Weights of the states of a formula, the newest of the known ones first.
struct StepWeights {
  std::array<double, 3> ahead;  ///< of the state extrapolated to the end of the step
  std::array<double, 3> from;   ///< of that from which the step goes
  double tau;                   ///< (x_new − x_from)/tau = rate at the end
};

/// Of a step from 0 to t[0] > 0 and states at t[1] = 0 > t[2] > …, `steps` of them (1 … 3): the derivative at t[0] of the polynomial
/// through all, and the value there of that through the known ones (Hairer, Nørsett, Wanner I, III.5).
inline StepWeights step_weights(const std::array<double, 4>& t, int steps) {
  StepWeights w{};
  double newest = 0;
  for (int j = 1; j <= steps; ++j) newest += 1 / (t[0] - t[std::size_t(j)]);
  for (int j = 1; j <= steps; ++j) {
    const double tj = t[std::size_t(j)];
    double ahead = 1;
    for (int k = 1; k <= steps; ++k)
      if (k != j) ahead *= (t[0] - t[std::size_t(k)]) / (tj - t[std::size_t(k)]);
    w.ahead[std::size_t(j - 1)] = ahead;
    w.from[std::size_t(j - 1)] = ahead / ((t[0] - tj) * newest);
  }
  w.tau = 1 / newest;
  return w;
}

/// An integrator that remembers the states before the last two steps. It solves
///   (x_new − x_from)/τ' = rate
/// at the state that is extrapolated to the end of the step, where the equations are linearised. Its error is reported as that
/// of the formula with one step less: of two steps as that of a first-order step, as by StepDoubling, which makes the first step, a quarter of
/// τ² ẍ; of three as that of two, 2/9 τ³ x⃛. Which one the next step has is decided by which of these errors lets it be longer: near rest, where
/// both let it be the longest, and where what explicit terms do oscillates from step to step, it is that of two, which is more stable.
template <TwoStepSolver Solver>
class MultiStep {
 public:
  using State = typename Solver::State;
  using Past = model::Past<State>;

  /// `most_steps`: 2 or 3.
  MultiStep(Solver& solver, const Target& target, const TimeControl& control, int most_steps)
      : largest_growth(most_steps == 2 ? 2 : 1.4),
        solver_(solver),
        target_(target),
        control_(control),
        most_steps_(most_steps) {}

  const double largest_growth;  ///< three steps are stable below 1.53, two below 1 + √2

  FlowStep<State> advance(const State& old, double tau) {
    if (history_.past.empty()) {
      auto first = StepDoubling<Solver>(solver_, target_, true).advance(old, tau);
      rates_ = first.dissipation;
      return first;
    }
    const bool three = steps() == 3;
    const StepWeights w = step_weights(times(tau), steps());
    const State at = sum(w.ahead, old);
    auto result = solver_.step(at, sum(w.from, old), w.tau);
    if (!result.ok()) return result;
    result.error_order = three ? 3 : 2;
    result.error = three ? error_of_two_steps(at, result.state, tau)
                         : error_of_one_step(at, result.state, tau);
    choose_steps(old, result, tau);
    rates_ = result.dissipation;
    result.dissipation = mean_rates(tau);
    complete(solver_, target_, result);
    return result;
  }

  void accept(const State& old, const FlowStep<State>&, double tau) {
    history_.past.insert(history_.past.begin(), Past{old, tau, rates_});
    if (history_.past.size() > 2) history_.past.pop_back();
    history_.steps = next_steps_;
  }
  void forget() { recall({}); }

  const StepHistory<State>& history() const { return history_; }
  void recall(const StepHistory<State>& history) {
    history_ = history;
    next_steps_ = history.steps;
  }

 private:
  int steps() const { return history_.past.size() < 2 ? 2 : std::min(history_.steps, most_steps_); }
  const Past& last() const { return history_.past[0]; }

  std::array<double, 4> times(double tau) const {
    std::array<double, 4> t{tau, 0, 0, 0};
    for (std::size_t k = 0; k < history_.past.size(); ++k)
      t[k + 2] = t[k + 1] - history_.past[k].tau;
    return t;
  }
  State sum(const std::array<double, 3>& weights, const State& old) const {
    State x{weights[0] * old.X, weights[0] * old.beta};
    for (std::size_t k = 0; k < history_.past.size(); ++k) {
      if (weights[k + 1] == 0) continue;
      x.X += weights[k + 1] * history_.past[k].state.X;
      x.beta += weights[k + 1] * history_.past[k].state.beta;
    }
    return x;
  }

  // By the state extrapolated linearly, or quadratically.
  double error_of_one_step(const State& ahead, const State& end, double tau) const {
    return tau / (2 * (tau + last().tau)) * solver_.distance(ahead, end).largest();
  }
  double error_of_two_steps(const State& ahead, const State& end, double tau) const {
    const std::array<double, 4> t = times(tau);
    return step_weights(t, 2).tau / (t[0] - t[3]) * solver_.distance(ahead, end).largest();
  }

  // After a step to `end`, by how long the next one may be.
  void choose_steps(const State& old, const FlowStep<State>& end, double tau) {
    next_steps_ = most_steps_;
    if (most_steps_ == 2 || history_.past.size() < 2) return;
    const auto ahead = [&](int steps) { return sum(step_weights(times(tau), steps).ahead, old); };
    const double two =
                     end.error_order == 2 ? end.error : error_of_one_step(ahead(2), end.state, tau),
                 three = end.error_order == 3 ? end.error
                                              : error_of_two_steps(ahead(3), end.state, tau);
    const auto longest = [&](double error, int order) {
      return std::min(control_.largest_step, tau * wanted_growth(control_.tolerance, error, order));
    };
    if (longest(three, 3) <= longest(two, 2)) next_steps_ = 2;
  }

  // Over the step: of the polynomial through the rates at its ends and, of three steps, at the one before.
  Dissipation mean_rates(double tau) const {
    if (steps() == 2) return combine(0.5, last().dissipation, 0.5, rates_);
    const double r = tau / last().tau;
    const Dissipation known = combine((r + 3) / 6, last().dissipation, -r * r / (6 * (1 + r)),
                                      history_.past[1].dissipation);
    return combine(1, known, (2 * r + 3) / (6 * (1 + r)), rates_);
  }

  Solver& solver_;
  Target target_;
  TimeControl control_;
  int most_steps_;
  StepHistory<State> history_;
  int next_steps_ = 2;  // of the formula after the last step tried
  Dissipation rates_;   // at the end of the last step tried
};

}  // namespace sbeh::model
