#include "axisym/flow.h"

#include "axisym/curvature.h"

#include <algorithm>
#include <cmath>

namespace sbeh::axisym {

namespace {

// A rise of the energy is the time step's fault when it is more than rounding and when the step's error
// is not negligible; otherwise it is the mesh's, whose motion moves the discrete energy a little.
constexpr double energy_noise = 1e-10;     // relative
constexpr double negligible_error = 1e-2;  // of the tolerance

// A step of the controlled scheme: one step of τ against two of τ/2.
struct Trial {
  bool ok = false;
  State state;
  Dissipation dissipation;
  double lambda = 0, speed_max = 0;
  double error = 0;  // of the first-order result: largest normal distance and change of order
};

double largest_difference(const State& a, const State& b, const Nodes& normals) {
  return std::max((a.X - b.X).cwiseProduct(normals).colwise().sum().cwiseAbs().maxCoeff(),
                  (a.beta - b.beta).cwiseAbs().maxCoeff());
}

Dissipation combine(double a, const Dissipation& x, double b, const Dissipation& y) {
  return {a * x.friction + b * y.friction, a * x.order + b * y.order,
          a * x.viscous + b * y.viscous};
}

Trial try_step(TimeStepper& stepper, const State& old, const Target& target, double tau,
               bool extrapolate) {
  Trial trial;
  const StepResult whole = stepper.step(old, target, tau);
  if (!whole.ok) return trial;
  const StepResult first = stepper.step(old, target, tau / 2);
  if (!first.ok) return trial;
  // Every step of the extrapolation begins without drift: pulled back halfway, the two halves would
  // have lost what the whole step is to cancel.
  const Target middle = extrapolate ? Target{area(first.state.X), volume(first.state.X)} : target;
  const StepResult second = stepper.step(first.state, middle, tau / 2);
  if (!second.ok) return trial;

  trial.error = largest_difference(second.state, whole.state, node_normals(old.X));
  trial.lambda = second.fields.lambda;
  trial.speed_max = second.fields.V.colwise().norm().maxCoeff();
  const Dissipation halves = combine(0.5, first.dissipation, 0.5, second.dissipation);
  if (extrapolate) {  // the first-order errors cancel
    trial.state = {2 * second.state.X - whole.state.X, 2 * second.state.beta - whole.state.beta};
    trial.dissipation = combine(2, halves, -1, whole.dissipation);
  } else {
    trial.state = second.state;
    trial.dissipation = halves;
  }
  trial.ok = std::isfinite(trial.error) && trial.state.X.row(0).minCoeff() >= 0
          && correct_area_volume(trial.state.X, target.area, target.volume);
  return trial;
}

FlowRecord record_of(const Trial& trial, const State& old, double tau, const Energy& before,
                     const Energy& after) {
  FlowRecord r;
  r.time_step = tau;
  r.energy = after;
  r.dissipation = trial.dissipation;
  const double spent = tau * trial.dissipation.total();
  r.energy_balance = spent > 0 ? (before.total() - after.total()) / spent : 1;
  const Nodes n = node_normals(old.X);
  r.normal_speed =
      (trial.state.X - old.X).cwiseProduct(n).colwise().sum().cwiseAbs().maxCoeff() / tau;
  r.order_speed = (trial.state.beta - old.beta).cwiseAbs().maxCoeff() / tau;
  r.lambda = trial.lambda;
  r.speed_max = trial.speed_max;
  return r;
}

// The output times and the end, ascending; those that differ by rounding are one.
std::vector<double> stops_of(const FlowSchedule& schedule) {
  std::vector<double> stops = schedule.output_times;
  stops.push_back(schedule.end_time);
  std::sort(stops.begin(), stops.end());
  const auto same = [](double a, double b) { return b - a <= same_time * std::abs(b); };
  stops.erase(std::unique(stops.begin(), stops.end(), same), stops.end());
  if (same(stops.back(), schedule.end_time)) stops.back() = schedule.end_time;
  return stops;
}

}  // namespace

std::string describe(FlowStop stop) {
  switch (stop) {
    case FlowStop::end_time:
      return "end time reached";
    case FlowStop::at_rest:
      return "at rest";
    case FlowStop::unresolved:
      return "curvature falls below the mesh scale";
    case FlowStop::step_too_small:
      return "time step too small";
    case FlowStop::interrupted:
      return "interrupted";
  }
  return "";
}

FlowResult run_flow(const model::Material& material, model::Model model, const State& start,
                    const Target& target, const Numerics& numerics, const FlowSchedule& schedule,
                    const FlowObserver& observe) {
  FlowResult run{.stop = FlowStop::end_time, .state = start, .last = {}, .steps = 0};
  run.last.energy = energy(material, start, mean_curvature(start.X));
  TimeStepper stepper(material, model, element_count(start.X));

  const std::vector<double> stops = stops_of(schedule);
  auto next = stops.begin();
  const bool starts_with_output = *next <= 0;
  while (next != stops.end() && *next <= 0) ++next;
  if (observe && !observe(run.last, run.state, starts_with_output))
    return run.stop = FlowStop::interrupted, run;

  double tau = numerics.first_step;
  while (run.last.time < schedule.end_time) {
    const double remaining = *next - run.last.time;
    const bool exact = tau >= remaining * (1 - 1e-9);
    const double used = exact ? remaining : std::min(tau, remaining / 2);
    const Trial trial = try_step(stepper, run.state, target, used, numerics.extrapolate);
    const Energy before = run.last.energy;
    const Energy after =
        trial.ok ? energy(material, trial.state, mean_curvature(trial.state.X)) : Energy{};
    const bool rises =
        !(after.total() <= before.total() + energy_noise * (1 + std::abs(before.total())))
        && trial.error > negligible_error * numerics.tolerance;
    if (!trial.ok || rises || trial.error > numerics.tolerance) {
      const double wanted = trial.ok && !rises ? std::sqrt(numerics.tolerance / trial.error) : 0;
      tau = used * std::clamp(0.9 * wanted, 0.1, 0.5);
      ++run.last.rejected;
      if (tau < numerics.smallest_step) return run.stop = FlowStop::step_too_small, run;
      continue;
    }
    const double grow = std::clamp(0.9 * std::sqrt(numerics.tolerance / trial.error), 0.3, 2.);
    // A step cut short by an output time says little about the next one.
    tau = std::min(numerics.largest_step, std::max(exact ? tau : 0, used * grow));
    FlowRecord record = record_of(trial, run.state, used, before, after);
    record.time = exact ? *next : run.last.time + used;
    record.rejected = run.last.rejected;
    run.last = record;
    run.state = trial.state;
    ++run.steps;
    if (exact) ++next;
    if (observe && !observe(run.last, run.state, exact))
      return run.stop = FlowStop::interrupted, run;
    if (diagnose(material, run.state).resolution > resolution_limit)
      return run.stop = FlowStop::unresolved, run;
    if (schedule.stop_at_rest
        && std::max(run.last.normal_speed, run.last.order_speed) < numerics.rest_speed)
      return run.stop = FlowStop::at_rest, run;
  }
  return run;
}

}  // namespace sbeh::axisym
