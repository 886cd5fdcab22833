// One step of τ against two of τ/2: an estimate of the error, and second order by extrapolation.
#pragma once

#include "model/numerics/area_volume.h"
#include "model/time/flow_record.h"

#include <cmath>
#include <concepts>
#include <limits>
#include <optional>

namespace sbeh::model {

/// A solver whose State has X and beta, which can be added and multiplied by numbers.
template <class S>
concept OneStepSolver = requires(S solver, typename S::State state, const typename S::State& old,
                                 const Target& target, double tau) {
  // of first order; without a target it keeps the area and volume that `old` has
  { solver.step(old, std::optional(target), tau) } -> std::same_as<FlowStep<typename S::State>>;
  { solver.restore(state, target) } -> std::same_as<bool>;  // false where that fails
  { solver.distance(old, old) } -> std::same_as<Distance>;
};

/// The end of a step: its area and volume are brought back to the target, to rounding.
template <OneStepSolver Solver>
void complete(Solver& solver, const Target& target, FlowStep<typename Solver::State>& step) {
  if (!std::isfinite(step.error))
    step.fault = FlowFault::degenerate;
  else if (!solver.restore(step.state, target))
    step.fault = FlowFault::area_volume;
}

/// An integrator without memory.
template <OneStepSolver Solver>
class StepDoubling {
 public:
  using State = typename Solver::State;
  static constexpr double largest_growth = std::numeric_limits<double>::infinity();

  StepDoubling(Solver& solver, const Target& target, bool extrapolate)
      : solver_(solver), target_(target), extrapolate_(extrapolate) {}

  FlowStep<State> advance(const State& old, double tau) {
    auto whole = solver_.step(old, target_, tau);
    if (!whole.ok()) return whole;
    auto first = solver_.step(old, target_, tau / 2);
    if (!first.ok()) return first;
    // Every step of the extrapolation begins without drift: pulled back halfway, the two halves would
    // have lost what the whole step is to cancel.
    const auto middle = extrapolate_ ? std::nullopt : std::optional(target_);
    auto result = solver_.step(first.state, middle, tau / 2);
    if (!result.ok()) return result;

    result.error = solver_.distance(result.state, whole.state).largest();
    result.dissipation = combine(0.5, first.dissipation, 0.5, result.dissipation);
    if (extrapolate_) {  // the first-order errors cancel
      result.state.X = 2 * result.state.X - whole.state.X;
      result.state.beta = 2 * result.state.beta - whole.state.beta;
      result.dissipation = combine(2, result.dissipation, -1, whole.dissipation);
    }
    complete(solver_, target_, result);
    return result;
  }

  void accept(const State&, const FlowStep<State>&, double) {}
  void forget() {}

 private:
  Solver& solver_;
  Target target_;
  bool extrapolate_;
};

}  // namespace sbeh::model
