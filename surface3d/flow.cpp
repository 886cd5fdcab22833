#include "surface3d/flow.h"

#include "model/order_step.h"
#include "model/relaxation.h"
#include "model/time/flow.h"
#include "model/time/implicit_euler.h"
#include "model/time/multi_step.h"
#include "surface3d/lipids.h"
#include "surface3d/mesh/self_contact.h"
#include "surface3d/order_step.h"
#include "surface3d/symmetry.h"
#include "surface3d/variational/variational_stepper.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <stdexcept>
#include <utility>

namespace sbeh::surface3d {

namespace {

// In sides of a triangle. Sheets do not act on each other however near they are, so that a run may go on
// until they all but meet.
constexpr double touching = 0.05;

// Steps, and what else model::Flow asks of a solver.
template <class Stepper>
class Solver {
 public:
  using State = surface3d::State;

  Solver(std::shared_ptr<const Triangulation> mesh, const model::Material& material,
         model::Model model, const Numerics& numerics, const FlowSymmetry& symmetry,
         const State& state, const Ranks& ranks)
      : ranks_(ranks),
        whole_(std::move(mesh)),
        mesh_(parted(whole_)),
        material_(has_free_order(model) ? material : material.with_uniform_order()),
        model_(model),
        numerics_(numerics),
        symmetry_(symmetry),
        kept_(kept_by(*mesh_, state)),
        stepper_(std::make_unique<Stepper>(mesh_, material_, model_, numerics_)) {}

  FlowStep step(const auto&... of) { return stepper_->step(of...); }

  bool restore(State& state, const Target& target) const {
    const auto project = [&] {
      if (kept_) state = symmetric_part(*kept_, state);
    };
    project();
    if (!correct_lipids_volume(*mesh_, material_, stepper_->fields().H, target, state))
      return false;
    project();  // what the quadrature's lack of symmetry has made of H: of second order in area and volume
    if (target.order)
      state.beta.array() += (*target.order - total_order(*mesh_, state)) / area(*mesh_, state.X);
    return true;
  }
  model::Distance distance(const State& a, const State& b) const {
    const Nodes n = node_normals(*mesh_, a.X);
    return {(b.X - a.X).cwiseProduct(n).colwise().sum().cwiseAbs().maxCoeff(),
            (b.beta - a.beta).cwiseAbs().maxCoeff()};
  }
  Energy energy(const State& state) {
    curvature_ = curvature_of(*mesh_, state.X);
    return curvature_ ? stepper_->energy(state, *curvature_) : unknown;
  }
  // With the curvature that energy() has found.
  Energy own_energy(const State& state) const requires requires(Stepper s, const Curvature& c) {
    s.own_energy(state, c);
  }
  { return curvature_ ? stepper_->own_energy(state, *curvature_) : unknown; }
  bool renew(State& state);
  std::optional<FlowStop> obstacle(const State& state) const {
    if (!(mesh_quality(*mesh_, state.X) > degenerate_quality)) return FlowStop::unresolved;
    if (!self_contacts(*mesh_, state.X, touching).empty()) return FlowStop::self_contact;
    return {};
  }

  bool recall(const FlowMemory& memory) {
    remeshing_over_ = memory.remeshing_over;
    return stepper_->recall(memory.stepper);
  }
  StepView view(const model::StepHistory<State>& history) const {
    return {.fields = stepper_->fields(),
            .memory = {stepper_->memory(), history, remeshing_over_},
            .mesh = whole_,
            .indicators = indicators_,
            .remeshed = remeshed_};
  }
  /// Before the first step.
  void look_at(const State& state) {
    if (!curvature_) curvature_ = curvature_of(*mesh_, state.X);
    if (curvature_) indicators_ = indicators_of(*mesh_, state.X, *curvature_);
  }

 private:
  static constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  static constexpr Energy unknown{nan, nan, nan};

  std::optional<meshing::MeshSymmetry> kept_by(const Triangulation& mesh,
                                               const State& state) const {
    if (symmetry_.kept.is_trivial()) return {};
    return required_symmetry(mesh, state, symmetry_.kept);
  }

  std::shared_ptr<const Triangulation> parted(
      const std::shared_ptr<const Triangulation>& mesh) const {
    if (ranks_.is_alone()) return mesh;
    return std::make_shared<const Triangulation>(*mesh, ranks_);
  }

  Ranks ranks_;
  std::shared_ptr<const Triangulation> whole_,
      mesh_;  // as observers see it; parted among the ranks
  model::Material material_;
  model::Model model_;
  Numerics numerics_;
  FlowSymmetry symmetry_;
  std::optional<meshing::MeshSymmetry> kept_;  // empty: none
  std::unique_ptr<Stepper> stepper_;
  std::optional<Curvature> curvature_;  // of the state whose energy was asked for last
  Indicators indicators_{};
  std::optional<RemeshResult> remeshed_;
  bool remeshing_over_ = false;
};
using LinearSolver = Solver<TimeStepper>;
using MinimalSolver = Solver<VariationalStepper>;
static_assert(model::FlowSolver<LinearSolver> && model::TwoStepSolver<LinearSolver>);
static_assert(model::FlowIntegrator<model::StepDoubling<LinearSolver>, State>);
static_assert(model::FlowIntegrator<model::MultiStep<LinearSolver>, State>);
static_assert(model::FlowIntegrator<model::ImplicitEuler<MinimalSolver>, State>);

template <class Stepper>
bool Solver<Stepper>::renew(State& state) {
  remeshed_.reset();
  look_at(state);
  if (!numerics_.remesh || remeshing_over_ || resolved(indicators_)) return false;
  const int triangles = std::min(numerics_.most_triangles, mesh_->count() * 3 / 2);
  remeshed_ =
      remesh(*whole_, state, material_, {.triangles = triangles, .symmetry = symmetry_.kept});
  if (!remeshed_->mesh) return remeshing_over_ = true, false;
  whole_ = remeshed_->mesh;
  mesh_ = parted(whole_);
  state = remeshed_->state;
  kept_ = kept_by(*mesh_, state);
  stepper_ = std::make_unique<Stepper>(mesh_, material_, model_, numerics_);
  const auto curvature = curvature_of(*mesh_, state.X);
  remeshing_over_ = triangles == numerics_.most_triangles
                 && !(curvature && resolved(indicators_of(*mesh_, state.X, *curvature)));
  return true;
}

}  // namespace

void Numerics::validate() const {
  model::check_parameters(*this);
  TimeControl::validate();
  if ((integrator == Integrator::multi_step || integrator == Integrator::two_step) && !extrapolate)
    throw std::invalid_argument(fmt::format(
        "extrapolate = false: must be true with integrator = \"{}\", which is of second "
        "order at least",
        name(integrator)));
}

namespace {

// `memory` remembers the past, for the observer; `integrator`, perhaps the same, makes the steps.
template <class Stepper, class Memory, class Integrator>
FlowResult run_with(Solver<Stepper>& solver, Memory& memory, Integrator& integrator,
                    const FlowMoment& start, const Numerics& numerics, double at_rest,
                    const FlowSchedule& schedule, const FlowObserver& observe) {
  if (!solver.recall(start.memory))
    return {.stop = FlowStop::step_too_small,
            .state = start.state,
            .last = start.record,
            .steps = 0,
            .fault = model::FlowFault::linear_solve};
  memory.recall(start.memory.history);
  model::FlowObserver<State> observer;
  if (observe)
    observer = [&](const FlowRecord& record, const State& state, bool exact) {
      if (record.time_step == 0) solver.look_at(state);
      return observe(record, state, solver.view(memory.history()), exact);
    };
  return model::Flow(solver, integrator, numerics, at_rest)
      .run(start.state, start.record, schedule, observer);
}

// Throws std::invalid_argument where they have no place to go to.
Target lipids_of(const FlowMoment& start, const model::Material& material) {
  const Triangulation& mesh = *start.mesh;
  if (is_sphere(mesh, area(mesh, start.state.X), volume(mesh, start.state.X)))
    throw std::invalid_argument(model::no_lipids_on_spheres);
  return lipids_and_volume(mesh, material, start.state);
}

}  // namespace

FlowResult run_flow(const model::Material& given, model::Model model, const FlowMoment& start,
                    const Numerics& numerics, const FlowSchedule& schedule,
                    const FlowObserver& observe, const Ranks& ranks) {
  if (start.record.time == 0)
    given.area_difference.check_start(diagnose(*start.mesh, given, start.state).W2);
  Target target = start.target;
  model::Material material = given;
  if (has_free_order(model) && material.has_lipid_density() && start.record.time == 0)
    target = lipids_of(start, material);
  if (has_free_order(model) && material.conserves_order()) {
    target.order =
        model::conserved_order(material, start.target.area, total_order(*start.mesh, start.state));
    material.mean_order = *target.order / target.area;
  }
  const double at_rest = model::speed_at_rest(numerics.rest_speed, material, model);
  const auto run = [&](auto& solver, auto& memory, auto& integrator) {
    return run_with(solver, memory, integrator, start, numerics, at_rest, schedule, observe);
  };
  const bool variational = numerics.integrator == Integrator::variational;
  if (variational && area_constraint(model) == model::AreaConstraint::global)
    throw std::invalid_argument(
        fmt::format("integrator = \"variational\": {}", no_variational_steps));
  if (variational && material.order == model::OrderDynamics::diffusive)
    throw std::invalid_argument(
        "integrator = \"variational\": has no steps of order = \"diffusive\"");
  if (variational && !ranks.is_alone())
    throw std::invalid_argument("integrator = \"variational\": has no steps for several ranks");
  if (variational && !is_sphere(*start.mesh, start.target.area, start.target.volume)) {
    MinimalSolver solver(start.mesh, material, model, numerics, start.symmetry, start.state, ranks);
    model::ImplicitEuler<MinimalSolver> steps(solver, target);
    return run(solver, steps, steps);
  }
  LinearSolver solver(start.mesh, material, model, numerics, start.symmetry, start.state, ranks);
  model::MultiStep<LinearSolver> steps(solver, target, numerics,
                                       numerics.integrator == Integrator::two_step ? 2 : 3);
  if (numerics.integrator != Integrator::step_doubling) return run(solver, steps, steps);
  model::StepDoubling<LinearSolver> doubling(solver, target, numerics.extrapolate);
  return run(solver, steps, doubling);
}

}  // namespace sbeh::surface3d
