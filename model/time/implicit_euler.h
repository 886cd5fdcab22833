// Implicit steps of first order, one solve each, whose error the last step tells.
#pragma once

#include "model/time/multi_step.h"

namespace sbeh::model {

/// An integrator for a solver in whose steps the energy falls whatever their length, or that have a fault. With
/// r = τ/τ_before the error, τ² ẍ/2, is r/(1 + 2r) of the distance from x + r (x − x_before), where the last step leads on. The
/// first step is two halves, see StepDoubling.
template <OneStepSolver Solver>
class ImplicitEuler {
 public:
  using State = typename Solver::State;
  static constexpr double largest_growth = 2;
  static constexpr bool guards_energy = true;

  ImplicitEuler(Solver& solver, const Target& target) : solver_(solver), target_(target) {}

  FlowStep<State> advance(const State& old, double tau) {
    if (history_.past.empty())
      return StepDoubling<Solver>(solver_, target_, false).advance(old, tau);
    auto result = solver_.step(old, target_, tau);
    if (!result.ok()) return result;
    const Past<State>& last = history_.past.front();
    const double r = tau / last.tau;
    const State ahead{old.X + r * (old.X - last.state.X),
                      old.beta + r * (old.beta - last.state.beta)};
    result.error = r / (1 + 2 * r) * solver_.distance(ahead, result.state).largest();
    complete(solver_, target_, result);
    return result;
  }

  void accept(const State& old, const FlowStep<State>& step, double tau) {
    history_.past = {Past<State>{old, tau, step.dissipation}};
  }
  void forget() { history_ = {}; }

  const StepHistory<State>& history() const { return history_; }
  /// Of which the last step counts.
  void recall(const StepHistory<State>& history) { history_ = history; }

 private:
  Solver& solver_;
  Target target_;
  StepHistory<State> history_;
};

}  // namespace sbeh::model
