// The backward differentiation formula of two steps: second order in τ for one solve a step.
#pragma once

#include "model/time/step_doubling.h"

namespace sbeh::model {

/// The state before the last step, and that step.
template <class State>
struct Past {
  State state;
  double tau;
  Dissipation dissipation;  ///< rates at its end
};

/// A solver that steps from one state with the coefficients of another, whose area and volume it keeps.
template <class S>
concept TwoStepSolver = OneStepSolver<S> && requires(S solver, const typename S::State& at,
                                                     const typename S::State& from, double tau) {
  { solver.step(at, from, tau) } -> std::same_as<FlowStep<typename S::State>>;
};

/// An integrator that remembers the state before the last step. With r = τ/τ_before it solves, at the
/// extrapolated state x + r (x − x_before), where the equations are linearised,
///   (x_new − x_from)/τ' = rate,  x_from = x + r²/(1 + 2r) (x − x_before),  τ' = τ (1 + r)/(1 + 2r).
/// Its error is reported as that of a first-order step, as by StepDoubling, which makes the first step:
/// a quarter of τ² ẍ.
template <TwoStepSolver Solver>
class TwoStep {
 public:
  using State = typename Solver::State;
  static constexpr double largest_growth = 2;  // stable below 1 + √2

  using Past = model::Past<State>;

  TwoStep(Solver& solver, const Target& target) : solver_(solver), target_(target) {}

  FlowStep<State> advance(const State& old, double tau) {
    if (!past_) {
      auto first = StepDoubling<Solver>(solver_, target_, true).advance(old, tau);
      rates_ = first.dissipation;
      return first;
    }
    const double r = tau / past_->tau;
    const auto ahead = [&](double by) -> State {
      return {old.X + by * (old.X - past_->state.X),
              old.beta + by * (old.beta - past_->state.beta)};
    };
    const State at = ahead(r);
    auto result = solver_.step(at, ahead(r * r / (1 + 2 * r)), tau * (1 + r) / (1 + 2 * r));
    if (!result.ok()) return result;
    result.error = r / (2 * (1 + r)) * solver_.distance(at, result.state).largest();
    rates_ = result.dissipation;
    result.dissipation = combine(0.5, past_->dissipation, 0.5, rates_);
    complete(solver_, target_, result);
    return result;
  }

  void accept(const State& old, const FlowStep<State>&, double tau) {
    past_ = Past{old, tau, rates_};
  }
  void forget() { past_.reset(); }

  const std::optional<Past>& past() const { return past_; }
  void recall(const std::optional<Past>& past) { past_ = past; }

 private:
  Solver& solver_;
  Target target_;
  std::optional<Past> past_;
  Dissipation rates_;  // at the end of the last step tried
};

}  // namespace sbeh::model
