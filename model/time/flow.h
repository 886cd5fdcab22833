// An evolution in time: adaptive steps, exact output times, and the reason why it stopped. What both
// solvers share; the physics of a step is theirs.
#pragma once

#include "model/parameter.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace sbeh::model {

/// The area and volume that a run keeps.
struct Target {
  double area;
  double volume;
};

/// Integrals of the energy density over the surface, dimensionless.
struct Energy {
  double distortion = 0;    ///< ∫ (l₁/2)|∇β|²
  double bending = 0;       ///< ∫ (κ/2)(H − H₀)² + κ_G K
  double thermotropic = 0;  ///< ∫ u(β)
  double total() const { return distortion + bending + thermotropic; }
};

/// Rates of dissipation: dU/dt = −(friction + order + viscous).
struct Dissipation {
  double friction = 0;  ///< ∫ γ_∥|PV|² + γ_⊥(V·ν)² dS
  double order = 0;     ///< ∫ (3/2)(M + μξ²/2) β̇² dS
  double viscous = 0;   ///< ∫ (η/2)|σ(V)|² dS
  double total() const { return friction + order + viscous; }
};
Dissipation combine(double a, const Dissipation& x, double b, const Dissipation& y);

/// How a run chooses its time steps; see the table below.
struct TimeControl {
  double tolerance = 1e-5;
  double first_step = 1e-6;
  double smallest_step = 1e-12;
  double largest_step =
      0.05;  // the explicit coupling of shape and order oscillates from about 0.1 on
  bool extrapolate = true;
  double rest_speed = 1e-6;

  /// Throws std::invalid_argument with name, value and constraint.
  void validate() const;

  bool operator==(const TimeControl&) const = default;
};

/// The table of its parameters.
template <maybe_const<TimeControl> T>
void for_each_parameter(T& control, auto&& visit) {
  using P = Parameter;
  visit(P{"tolerance", between(1e-12, 0.1), "error allowed in one step, of positions and order"},
        control.tolerance);
  visit(P{"first_step", between(1e-14, 10), "τ of the first try, also on a new mesh"},
        control.first_step);
  visit(P{"smallest_step", between(1e-16, 1), "τ below which the run stops: time step too small"},
        control.smallest_step);
  visit(P{"largest_step", between(1e-14, 1e3), "τ never exceeds it"}, control.largest_step);
  visit(P{"extrapolate",
          {},
          "a step and two half steps combined to second order in τ; false: the two half steps, "
          "first order"},
        control.extrapolate);
  visit(P{"rest_speed", between(1e-14, 1), "a run is stationary when no point is faster than this"},
        control.rest_speed);
}

enum class FlowStop { end_time, at_rest, unresolved, self_contact, step_too_small, interrupted };
/// Words for tables and messages.
std::string describe(FlowStop stop);

/// One accepted step as observers see it.
struct FlowRecord {
  double time = 0;       ///< at its end
  double time_step = 0;  ///< τ, 0 for the start
  Energy energy;
  Dissipation dissipation;            ///< mean rates over the step
  double energy_balance = 1;          ///< (U_old − U_new)/(τ · dissipation): 1 + O(τ)
  double normal_speed = 0;            ///< largest normal displacement per time
  double order_speed = 0;             ///< largest change of order per time
  double speed_max = 0;               ///< largest speed of the material, |V|
  double lambda = 0;                  ///< volume multiplier
  double next_step = 0;               ///< τ of the next try; 0 before a run has begun
  int rejected = 0;                   ///< steps rejected so far
  std::optional<FlowStop> ends = {};  ///< why the run ends with this step, if it does
};

/// Relative difference below which two output times are one.
inline constexpr double same_time = 1e-10;

struct FlowSchedule {
  double end_time = 1;
  std::vector<double>
      output_times;          ///< met exactly, in any order; those beyond the end are ignored,
                             ///< those that differ by less than same_time are met once
  bool stop_at_rest = true;  ///< at TimeControl::rest_speed
};

/// Why a step was not accepted.
enum class FlowFault {
  none,
  linear_solve,  ///< a system was singular, or its iteration did not converge
  degenerate,    ///< a triangle is turned over, or the curve or surface is not finite
  area_volume,   ///< area and volume could not be restored
  error,         ///< above the tolerance
  energy_rises
};
/// What was wrong and what may help, in one sentence; empty without a fault.
std::string describe(FlowFault fault);

/// Sees every accepted step; `exact` tells that the time is one of the output times. Returning false
/// interrupts the run.
template <class State>
using FlowObserver = std::function<bool(const FlowRecord&, const State&, bool exact)>;

template <class State>
struct FlowResult {
  FlowStop stop;
  State state;
  FlowRecord last;
  int steps;
  FlowFault fault = FlowFault::none;  ///< of the last step that was rejected
};

/// A step as the run sees it; the rest holds only when there is no fault.
template <class State>
struct FlowStep {
  FlowFault fault = FlowFault::linear_solve;
  State state = {};
  Dissipation dissipation = {};
  double lambda = 0, speed_max = 0;
  double error = 0;  ///< of a first-order step: largest normal distance or change of order
  bool ok() const { return fault == FlowFault::none; }
};

/// Largest normal distance and change of order between two states.
struct Distance {
  double normal, order;
};

/// The output times and the end, ascending; those that differ by rounding are one.
std::vector<double> stops_of(const FlowSchedule& schedule);

/// Runs a flow from `from` on. A Solver has a type State (a value, with X and beta) and
///   Distance distance(const State& a, const State& b)   along the normals of a
///   Energy energy(const State&)
///   bool renew(State&)                                  gives an accepted state a new mesh; true if so
///   std::optional<FlowStop> obstacle(const State&)      what makes an accepted state the last one
/// of which `energy` is asked before the other two;
/// and an Integrator
///   FlowStep<State> advance(const State& old, double tau)   with its error, area and volume kept
///   void accept(const State& old, const FlowStep<State>&, double tau)
///   void forget()                                           the past, which lived on another mesh
///   static constexpr double largest_growth                  of τ from one step to the next
/// A step is rejected and tried with a smaller τ when its error exceeds the tolerance, when a solve
/// fails, or when the energy rises and the step's error is not negligible; rejection leaves no trace
/// but the count.
template <class Solver, class Integrator>
class Flow {
 public:
  using State = typename Solver::State;
  Flow(Solver& solver, Integrator& integrator, const TimeControl& control)
      : solver_(solver), integrator_(integrator), control_(control) {}

  /// From a time on; `from.energy` may be left out at the start.
  FlowResult<State> run(const State& start, const FlowRecord& from, const FlowSchedule& schedule,
                        const FlowObserver<State>& observe = {});

 private:
  FlowFault fault_of(const FlowStep<State>& step, const Energy& before, const Energy& after) const;
  FlowRecord record_of(const FlowStep<State>& step, const State& old, double tau,
                       const Energy& before, const Energy& after);
  void renew_mesh(FlowResult<State>& run, double& tau);
  std::optional<FlowStop> end_of(const FlowResult<State>& run, const FlowSchedule& schedule);

  // A rise of the energy is the time step's fault when it is more than rounding and when the step's
  // error is not negligible; otherwise it is the mesh's, whose motion moves the discrete energy.
  static constexpr double energy_noise = 1e-10;     // relative
  static constexpr double negligible_error = 1e-2;  // of the tolerance

  Solver& solver_;
  Integrator& integrator_;
  TimeControl control_;
};

template <class Solver, class Integrator>
FlowFault Flow<Solver, Integrator>::fault_of(const FlowStep<State>& step, const Energy& before,
                                             const Energy& after) const {
  if (!step.ok()) return step.fault;
  if (!(step.error <= control_.tolerance)) return FlowFault::error;
  const bool rises =
      !(after.total() <= before.total() + energy_noise * (1 + std::abs(before.total())));
  return rises && step.error > negligible_error * control_.tolerance ? FlowFault::energy_rises
                                                                     : FlowFault::none;
}

template <class Solver, class Integrator>
FlowRecord Flow<Solver, Integrator>::record_of(const FlowStep<State>& step, const State& old,
                                               double tau, const Energy& before,
                                               const Energy& after) {
  FlowRecord r;
  r.time_step = tau;
  r.energy = after;
  r.dissipation = step.dissipation;
  const double spent = tau * step.dissipation.total();
  r.energy_balance = spent > 0 ? (before.total() - after.total()) / spent : 1;
  const Distance moved = solver_.distance(old, step.state);
  r.normal_speed = moved.normal / tau;
  r.order_speed = moved.order / tau;
  r.lambda = step.lambda;
  r.speed_max = step.speed_max;
  return r;
}

template <class Solver, class Integrator>
FlowResult<typename Solver::State> Flow<Solver, Integrator>::run(
    const State& start, const FlowRecord& from, const FlowSchedule& schedule,
    const FlowObserver<State>& observe) {
  FlowResult<State> run{.stop = FlowStop::end_time, .state = start, .last = from, .steps = 0};
  run.last.energy = solver_.energy(start);
  double tau = from.next_step > 0 ? from.next_step : control_.first_step;
  run.last.next_step = tau;

  const std::vector<double> stops = stops_of(schedule);
  auto next = stops.begin();
  const bool begins_with_output = *next <= from.time;
  while (next != stops.end() && *next <= from.time) ++next;
  const bool begins = from.next_step == 0;  // and does not go on
  if (begins && observe && !observe(run.last, run.state, begins_with_output))
    return run.stop = FlowStop::interrupted, run;

  while (run.last.time < schedule.end_time) {
    const double remaining = *next - run.last.time;
    const bool exact = tau >= remaining * (1 - 1e-9);
    const double used = exact ? remaining : std::min(tau, remaining / 2);
    const FlowStep<State> step = integrator_.advance(run.state, used);
    const Energy before = run.last.energy;
    const Energy after = step.ok() ? solver_.energy(step.state) : Energy{};
    const double wanted = 0.9 * std::sqrt(control_.tolerance / step.error);
    if (const FlowFault fault = fault_of(step, before, after); fault != FlowFault::none) {
      tau = used * (fault == FlowFault::error ? std::clamp(wanted, 0.1, 0.5) : 0.1);
      ++run.last.rejected;
      run.fault = fault;
      if (tau < control_.smallest_step) return run.stop = FlowStop::step_too_small, run;
      continue;
    }
    // A step cut short by an output time says little about the next one.
    tau = std::max(exact ? tau : 0, used * std::clamp(wanted, 0.3, 2.));
    tau = std::min({control_.largest_step, used * Integrator::largest_growth, tau});
    FlowRecord record = record_of(step, run.state, used, before, after);
    record.time = exact ? *next : run.last.time + used;
    record.rejected = run.last.rejected;
    integrator_.accept(run.state, step, used);
    run.last = record;
    run.state = step.state;
    run.fault = FlowFault::none;
    ++run.steps;
    if (exact) ++next;
    renew_mesh(run, tau);
    run.last.next_step = tau;
    run.last.ends = end_of(run, schedule);
    if (observe && !observe(run.last, run.state, exact))
      return run.stop = FlowStop::interrupted, run;
    if (run.last.ends) return run.stop = *run.last.ends, run;
  }
  return run;
}

template <class Solver, class Integrator>
void Flow<Solver, Integrator>::renew_mesh(FlowResult<State>& run, double& tau) {
  if (!solver_.renew(run.state)) return;
  integrator_.forget();
  run.last.energy = solver_.energy(run.state);
  tau = std::min(tau, control_.first_step);  // the new mesh settles
}

template <class Solver, class Integrator>
std::optional<FlowStop> Flow<Solver, Integrator>::end_of(const FlowResult<State>& run,
                                                         const FlowSchedule& schedule) {
  if (const auto obstacle = solver_.obstacle(run.state)) return obstacle;
  if (schedule.stop_at_rest
      && std::max(run.last.normal_speed, run.last.order_speed) < control_.rest_speed)
    return FlowStop::at_rest;
  if (run.last.time >= schedule.end_time) return FlowStop::end_time;
  return {};
}

}  // namespace sbeh::model
