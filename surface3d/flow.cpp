#include "surface3d/flow.h"

#include <utility>

namespace sbeh::surface3d {

namespace {

// What model::Flow asks of a solver.
class Solver {
 public:
  using State = surface3d::State;

  Solver(std::shared_ptr<const Triangulation> mesh, const model::Material& material,
         model::Model model, const Numerics& numerics)
      : mesh_(std::move(mesh)),
        material_(material),
        stepper_(mesh_, material, model, numerics.scheme, numerics.factorisation) {}

  model::FlowStep<State> step(const State& old, const Target& target, double tau) {
    return step(old, old, target, tau);
  }
  model::FlowStep<State> step(const State& at, const State& from, const Target& target,
                              double tau) {
    StepResult r = stepper_.step(at, from, target, tau);
    if (!r.ok()) return {.fault = r.fault};
    fields_ = std::move(r.fields);
    return {.fault = model::FlowFault::none,
            .state = std::move(r.state),
            .dissipation = r.dissipation,
            .lambda = fields_.lambda,
            .speed_max = fields_.V.colwise().norm().maxCoeff()};
  }
  const StepFields& fields() const { return fields_; }
  const StepperMemory& memory() const { return stepper_.memory(); }
  bool recall(const StepperMemory& memory) { return stepper_.recall(memory); }
  Target measure(const State& state) const {
    return {area(*mesh_, state.X), volume(*mesh_, state.X)};
  }
  bool restore(State& state, const Target& target) const {
    return correct_area_volume(*mesh_, state.X, target.area, target.volume);
  }
  model::Distance distance(const State& a, const State& b) const {
    const Nodes n = node_normals(*mesh_, a.X);
    return {(b.X - a.X).cwiseProduct(n).colwise().sum().cwiseAbs().maxCoeff(),
            (b.beta - a.beta).cwiseAbs().maxCoeff()};
  }
  Energy energy(const State& state) const {
    const auto curvature = curvature_of(*mesh_, state.X);
    const double nan = std::numeric_limits<double>::quiet_NaN();
    return curvature ? surface3d::energy(*mesh_, material_, state, *curvature)
                     : Energy{nan, nan, nan};
  }
  bool resolved(const State& state) const {
    return mesh_quality(*mesh_, state.X) > degenerate_quality;
  }

 private:
  std::shared_ptr<const Triangulation> mesh_;
  model::Material material_;
  TimeStepper stepper_;
  StepFields fields_;
};

}  // namespace

const char* name(Integrator integrator) {
  return integrator == Integrator::two_step ? "two-step" : "step-doubling";
}

FlowResult run_flow(const std::shared_ptr<const Triangulation>& mesh,
                    const model::Material& material, model::Model model, const FlowStart& start,
                    const Target& target, const Numerics& numerics, const FlowSchedule& schedule,
                    const FlowObserver& observe) {
  Solver solver(mesh, material, model, numerics);
  model::TwoStep<Solver> two_step(solver, target);
  if (!solver.recall(start.memory.stepper))
    return {.stop = FlowStop::step_too_small,
            .state = start.state,
            .last = start.record,
            .steps = 0,
            .fault = model::FlowFault::linear_solve};
  two_step.recall(start.memory.past);
  model::FlowObserver<State> observer;
  if (observe)
    observer = [&](const FlowRecord& record, const State& state, bool exact) {
      return observe(record, state, {solver.fields(), {solver.memory(), two_step.past()}}, exact);
    };
  const auto run = [&](auto& integrator) {
    return model::Flow(solver, integrator, numerics)
        .run(start.state, start.record, schedule, observer);
  };
  if (numerics.integrator == Integrator::two_step) return run(two_step);
  model::StepDoubling<Solver> doubling(solver, target, numerics.extrapolate);
  return run(doubling);
}

}  // namespace sbeh::surface3d
