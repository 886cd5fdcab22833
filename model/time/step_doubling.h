// One step of τ against two of τ/2: an estimate of the error, and second order by extrapolation.
#pragma once

#include "model/time/flow.h"

#include <algorithm>

namespace sbeh::model {

/// An Integrator of model::Flow without memory. The Solver has also
///   FlowStep<State> step(const State& old, const Target&, double tau)   of first order
///   Target measure(const State&)                                        area and volume
///   bool restore(State&, const Target&)             brings them back; false where that fails
/// and area and volume are kept at `target` to rounding.
template <class Solver>
class StepDoubling {
 public:
  using State = typename Solver::State;
  static constexpr double largest_growth = std::numeric_limits<double>::infinity();

  StepDoubling(Solver& solver, const Target& target, bool extrapolate)
      : solver_(solver), target_(target), extrapolate_(extrapolate) {}

  FlowStep<State> advance(const State& old, double tau);
  void accept(const State&, const FlowStep<State>&, double) {}
  void forget() {}

 private:
  Solver& solver_;
  Target target_;
  bool extrapolate_;
};

template <class Solver>
FlowStep<typename Solver::State> StepDoubling<Solver>::advance(const State& old, double tau) {
  auto whole = solver_.step(old, target_, tau);
  if (!whole.ok()) return whole;
  auto first = solver_.step(old, target_, tau / 2);
  if (!first.ok()) return first;
  // Every step of the extrapolation begins without drift: pulled back halfway, the two halves would
  // have lost what the whole step is to cancel.
  const Target middle = extrapolate_ ? solver_.measure(first.state) : target_;
  auto result = solver_.step(first.state, middle, tau / 2);
  if (!result.ok()) return result;

  const Distance distance = solver_.distance(result.state, whole.state);
  result.error = std::max(distance.normal, distance.order);
  result.dissipation = combine(0.5, first.dissipation, 0.5, result.dissipation);
  if (extrapolate_) {  // the first-order errors cancel
    result.state.X = 2 * result.state.X - whole.state.X;
    result.state.beta = 2 * result.state.beta - whole.state.beta;
    result.dissipation = combine(2, result.dissipation, -1, whole.dissipation);
  }
  if (!std::isfinite(result.error))
    result.fault = FlowFault::degenerate;
  else if (!solver_.restore(result.state, target_))
    result.fault = FlowFault::area_volume;
  return result;
}

}  // namespace sbeh::model
