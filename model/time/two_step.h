// The backward differentiation formula of two steps: second order in τ for one solve a step.
#pragma once

#include "model/time/step_doubling.h"

#include <optional>

namespace sbeh::model {

/// The state before the last step, and that step.
template <class State>
struct Past {
  State state;
  double tau;
  Dissipation dissipation;  ///< rates at its end
};

/// An Integrator of model::Flow that remembers the state before the last step. With r = τ/τ_before it
/// solves, at the extrapolated state x + r (x − x_before), where the equations are linearised,
///   (x_new − x_from)/τ' = rate,  x_from = x + r²/(1 + 2r) (x − x_before),  τ' = τ (1 + r)/(1 + 2r).
/// Its error is reported as that of a first-order step, as by StepDoubling, which makes the first step:
/// a quarter of τ² ẍ. The Solver has also
///   FlowStep<State> step(const State& at, const State& from, const Target&, double tau)
template <class Solver>
class TwoStep {
 public:
  using State = typename Solver::State;
  static constexpr double largest_growth = 2;  // stable below 1 + √2

  using Past = model::Past<State>;

  TwoStep(Solver& solver, const Target& target) : solver_(solver), target_(target) {}

  FlowStep<State> advance(const State& old, double tau);
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

template <class Solver>
FlowStep<typename Solver::State> TwoStep<Solver>::advance(const State& old, double tau) {
  if (!past_) {
    auto first = StepDoubling<Solver>(solver_, target_, true).advance(old, tau);
    rates_ = first.dissipation;
    return first;
  }
  const double r = tau / past_->tau;
  const auto ahead = [&](double by) -> State {
    return {old.X + by * (old.X - past_->state.X), old.beta + by * (old.beta - past_->state.beta)};
  };
  const State at = ahead(r);
  auto result = solver_.step(at, ahead(r * r / (1 + 2 * r)), solver_.measure(at),
                             tau * (1 + r) / (1 + 2 * r));
  if (!result.ok()) return result;
  const Distance distance = solver_.distance(at, result.state);
  result.error = r / (2 * (1 + r)) * std::max(distance.normal, distance.order);
  rates_ = result.dissipation;
  result.dissipation = combine(0.5, past_->dissipation, 0.5, rates_);
  if (!std::isfinite(result.error))
    result.fault = FlowFault::degenerate;
  else if (!solver_.restore(result.state, target_))
    result.fault = FlowFault::area_volume;
  return result;
}

}  // namespace sbeh::model
