// An evolution in time: adaptive steps, exact output times, and the reason why it stopped. What both
// solvers share; the physics of a step is theirs.
#pragma once

#include "model/time/step_control.h"

#include <algorithm>
#include <concepts>
#include <optional>

namespace sbeh::model {

/// What a run asks of a solver whose State is a value; `energy` before `renew` and `obstacle`.
template <class S>
concept FlowSolver = requires(S solver, typename S::State state, const typename S::State& given) {
  { solver.distance(given, given) } -> std::same_as<Distance>;  // along the normals of the first
  { solver.energy(given) } -> std::same_as<Energy>;
  { solver.renew(state) } -> std::same_as<bool>;  // gives it a new mesh; true if so
  // what makes an accepted state the last one
  { solver.obstacle(given) } -> std::same_as<std::optional<FlowStop>>;
};

// Steps are judged by U; of a solver that has own_energy(given), asked for right after energy(given), by that: what its scheme lets fall, which
// is U but for the error of the elements.

/// How a run steps from state to state: with the error of the step, area and volume kept.
template <class I, class State>
concept FlowIntegrator = requires(I integrator, const State& old, const FlowStep<State>& step,
                                  double tau) {
  { integrator.advance(old, tau) } -> std::same_as<FlowStep<State>>;
  integrator.accept(old, step, tau);
  integrator.forget();  // the past, which lived on another mesh
  { integrator.largest_growth } -> std::convertible_to<double>;  // of τ from one step to the next
};
// One whose steps have a fault by themselves where their energy rises, but for the motion of the mesh along itself, has a
// member guards_energy.

/// Runs a flow. A step is rejected and tried with a smaller τ when it could not be made or when
/// StepControl finds fault with it; rejection leaves no trace but the count, and the step after it no longer.
template <FlowSolver Solver, FlowIntegrator<typename Solver::State> Integrator>
class Flow {
 public:
  using State = typename Solver::State;
  /// `speed_at_rest`: below it nothing moves, see model/relaxation.h.
  Flow(Solver& solver, Integrator& integrator, const TimeControl& control, double speed_at_rest)
      : solver_(solver),
        integrator_(integrator),
        control_(control),
        speed_at_rest_(speed_at_rest) {}

  /// From a time on; `from.energy` may be left out at the start.
  FlowResult<State> run(const State& start, const FlowRecord& from, const FlowSchedule& schedule,
                        const FlowObserver<State>& observe = {}) {
    FlowResult<State> run{.stop = FlowStop::end_time, .state = start, .last = from, .steps = 0};
    StepControl steps(control_, integrator_.largest_growth, from.next_step);
    Stops stops(schedule, from.time);
    run.last.energy = solver_.energy(start);
    Energy own = own_energy(start, run.last.energy);
    run.last.next_step = steps.tau();
    const bool begins = from.next_step == 0;  // and does not go on
    if (begins && observe && !observe(run.last, run.state, stops.begin_at_one()))
      return run.stop = FlowStop::interrupted, run;

    while (run.last.time < schedule.end_time) {
      const Trial trial = steps.trial(stops.next() - run.last.time);
      const FlowStep<State> step = integrator_.advance(run.state, trial.tau);
      const Energy energy = step.ok() ? solver_.energy(step.state) : Energy{};
      const Energy own_after = step.ok() ? own_energy(step.state, energy) : Energy{};
      run.fault =
          step.ok() ? steps.judge(step.error, allowed(own, own_after), own_after) : step.fault;
      if (run.fault != FlowFault::none) {
        ++run.last.rejected;
        if (steps.reject(trial, run.fault, step.error, step.error_order)) continue;
        return run.stop = FlowStop::step_too_small, run;
      }
      steps.accept(trial, step.error, step.error_order);
      const EnergyRises rises = risen(run.last, own, own_after, trial.tau);
      run.last = record_of(step, trial.tau, run.state, run.last, energy, rises);
      own = own_after;
      if (trial.exact) run.last.time = stops.next(), stops.pass();
      integrator_.accept(run.state, step, trial.tau);
      run.state = step.state;
      ++run.steps;
      if (renew_mesh(run, steps)) own = own_energy(run.state, run.last.energy);
      run.last.next_step = steps.tau();
      run.last.ends = end_of(run, schedule);
      if (observe && !observe(run.last, run.state, trial.exact))
        return run.stop = FlowStop::interrupted, run;
      if (run.last.ends) return run.stop = *run.last.ends, run;
    }
    return run;
  }

 private:
  FlowRecord record_of(const FlowStep<State>& step, double tau, const State& old,
                       const FlowRecord& before, const Energy& after, const EnergyRises& rises) {
    const double spent = tau * step.dissipation.total();
    return {.time = before.time + tau,
            .time_step = tau,
            .energy = after,
            .dissipation = step.dissipation,
            .energy_balance = spent > 0 ? (before.energy.total() - after.total()) / spent : 1,
            .normal_speed = solver_.distance(old, step.state).normal / tau,
            .order_speed = step.order_speed,
            .speed_max = step.speed_max,
            .lambda = step.lambda,
            .rejected = before.rejected,
            .rises = rises};
  }

  // What the energy of a step may be, at most.
  static const Energy& allowed(const Energy& before, const Energy& after) {
    if constexpr (requires { Integrator::guards_energy; })
      return after;
    else
      return before;
  }

  Energy own_energy(const State& state, const Energy& energy) {
    if constexpr (requires { solver_.own_energy(state); })
      return solver_.own_energy(state);
    else
      return energy;
  }

  // New meshes have no part in it: `before` is on the mesh of the step.
  static EnergyRises risen(const FlowRecord& last, const Energy& before, const Energy& after,
                           double tau) {
    EnergyRises rises = last.rises;
    const double rise = after.total() - before.total();
    if (rise <= energy_noise(before)) return rises;
    if (rises.sum == 0) rises.from = last.time;
    rises.sum += rise;
    rises.to = last.time + tau;
    return rises;
  }

  bool renew_mesh(FlowResult<State>& run, StepControl& steps) {
    if (!solver_.renew(run.state)) return false;
    integrator_.forget();
    run.last.energy = solver_.energy(run.state);
    steps.restart();
    return true;
  }

  std::optional<FlowStop> end_of(const FlowResult<State>& run, const FlowSchedule& schedule) {
    if (const auto obstacle = solver_.obstacle(run.state)) return obstacle;
    if (schedule.stop_at_rest && run.last.speed() < speed_at_rest_) return FlowStop::at_rest;
    if (run.last.time >= schedule.end_time) return FlowStop::end_time;
    return {};
  }

  Solver& solver_;
  Integrator& integrator_;
  TimeControl control_;
  double speed_at_rest_;
};

}  // namespace sbeh::model
