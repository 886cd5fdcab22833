#include "surface3d/time_step.h"

#include "surface3d/diagnostics.h"
#include "surface3d/lagged_solver.h"
#include "surface3d/order_step.h"

#include <utility>

namespace sbeh::surface3d {

namespace {

Dissipation dissipation_of(const Triangulation& mesh, const model::Material& m, const State& old,
                           const StepFields& f, const Field& beta_new, double tau) {
  Dissipation d;
  const Field rate = (beta_new - old.beta) / tau;
  const Nodes slip = f.V - f.Y / tau;
  for_each_point(
      mesh, old.X, assembly_points(), [&](int e, const ShapeValues& s, const SurfacePoint& p) {
        const ElementNodes local_V = on_element(mesh, e, f.V);
        const Eigen::Vector3d V = value_at(local_V, s);
        const double beta = value_at(on_element(mesh, e, old.beta), s);
        const Eigen::Vector2d local_slip =
            p.frame.leftCols<2>().transpose() * value_at(on_element(mesh, e, slip), s);
        const double beta_dot = value_at(on_element(mesh, e, rate), s)
                              + local_slip.dot(gradient_at(on_element(mesh, e, beta_new), p));
        const double V_n = V.dot(p.nu());
        const model::Gradient<double> grad_V = p.frame.transpose() * gradient_at(local_V, p);
        d.friction += p.dS
                    * (m.friction_tangential * (V.squaredNorm() - V_n * V_n)
                       + m.friction_normal * V_n * V_n);
        d.order += p.dS * m.order_drag() * beta_dot * beta_dot;
        d.viscous += p.dS * m.eta(beta) / 2 * model::rate_of_strain(grad_V).squaredNorm();
      });
  return d;
}

// A tangential flow at the scale of the mesh enters the curvature equation of the split scheme: without
// viscosity, which damps it, that scheme is unstable.
Scheme stable_scheme(const model::Material& m, model::AreaConstraint area, Scheme wanted) {
  const bool damped = m.viscosity > 0 || area == model::AreaConstraint::global;
  return damped ? wanted : Scheme::monolithic;
}

CoupledSystem system_of(const Triangulation& mesh, const model::Material& material,
                        model::Model model, Scheme scheme) {
  const model::Material m = effective(material, model);
  const model::AreaConstraint area = area_constraint(model);
  return CoupledSystem(mesh, m, stable_scheme(m, area, scheme), area);
}

}  // namespace

struct TimeStepper::Workspace {
  std::shared_ptr<const Triangulation> mesh;
  model::Material material;
  model::Model model;
  Factorisation factorisation;
  CoupledSystem system;
  LaggedSolver flow, motion;
  StepperMemory memory;
  SolverCounts counts;

  void assemble(const State& old, const Curvature& curvature, const Target& target, double tau);
  bool worth_factoring() const;
  bool factor(const State& at, double tau);
  bool solve_with_factors(StepFields& out, int& iterations);
  bool solve_coupled(const State& old, const Curvature& curvature, const Target& target, double tau,
                     StepFields& out);
};

void TimeStepper::Workspace::assemble(const State& old, const Curvature& curvature,
                                      const Target& target, double tau) {
  const double A = area(*mesh, old.X), volume_now = volume(*mesh, old.X);
  system.assemble(*mesh, old, curvature, tau,
                  {.area_rate = (target.area - A) / (tau * A),
                   .volume_rate = (target.volume - volume_now) / tau,
                   .keep_volume = !is_sphere(*mesh, A, volume_now)});
}

// When the next solve is likely to cost more than the mean of all since the last factorisation,
// which it was part of.
bool TimeStepper::Workspace::worth_factoring() const {
  if (memory.solves == 0 || factorisation == Factorisation::every_step) return true;
  const double all = flow.cost_of_factoring() + memory.iterations;
  return memory.last_iterations > all / memory.solves;
}

bool TimeStepper::Workspace::factor(const State& at, double tau) {
  memory = {.factored_at = at, .factored_tau = tau};
  ++counts.factorisations;
  return flow.factor(system.flow().matrix)
      && (system.scheme() == Scheme::monolithic || motion.factor(system.motion().matrix));
}

bool TimeStepper::Workspace::solve_with_factors(StepFields& out, int& iterations) {
  Eigen::VectorXd solution = system.flow().rhs;
  iterations = flow.solve(system.flow().matrix, solution);
  if (iterations == 0) return false;
  out = {.V = system.velocity(solution),
         .Y = {},
         .H = system.curvature(solution),
         .p = system.pressure(solution),
         .lambda = system.lambda(solution)};
  if (system.scheme() == Scheme::split) {
    solution = system.motion().rhs;
    system.add_normal_motion(out.V, solution);
    if (motion.solve(system.motion().matrix, solution) == 0) return false;
  }
  out.Y = system.displacement(solution);
  return true;
}

// False when a matrix is singular.
bool TimeStepper::Workspace::solve_coupled(const State& old, const Curvature& curvature,
                                           const Target& target, double tau, StepFields& out) {
  assemble(old, curvature, target, tau);
  const bool fresh = worth_factoring();
  if (fresh && !factor(old, tau)) return memory = {}, false;
  int iterations = 0;
  if (!solve_with_factors(out, iterations)) {
    if (fresh || !factor(old, tau) || !solve_with_factors(out, iterations))
      return memory = {}, false;
  }
  ++memory.solves;
  memory.iterations += iterations;
  memory.last_iterations = iterations;
  ++counts.steps;
  counts.iterations += iterations;
  return true;
}

const char* name(Factorisation factorisation) {
  return factorisation == Factorisation::lagged ? "lagged" : "every-step";
}

TimeStepper::TimeStepper(std::shared_ptr<const Triangulation> mesh, const model::Material& material,
                         model::Model model, Scheme scheme, Factorisation factorisation)
    : work_(new Workspace{.mesh = mesh,
                          .material = effective(material, model),
                          .model = model,
                          .factorisation = factorisation,
                          .system = system_of(*mesh, material, model, scheme),
                          .flow = LaggedSolver(Symmetry::general),
                          .motion = LaggedSolver(Symmetry::symmetric),
                          .memory = {},
                          .counts = {}}) {}
TimeStepper::~TimeStepper() = default;
TimeStepper::TimeStepper(TimeStepper&&) noexcept = default;
TimeStepper& TimeStepper::operator=(TimeStepper&&) noexcept = default;

const StepperMemory& TimeStepper::memory() const { return work_->memory; }
SolverCounts TimeStepper::counts() const { return work_->counts; }

bool TimeStepper::recall(const StepperMemory& memory) {
  if (memory.solves == 0) return true;
  const State& at = memory.factored_at;
  const auto curvature = curvature_of(*work_->mesh, at.X);
  if (!curvature) return false;
  const Target target{area(*work_->mesh, at.X), volume(*work_->mesh, at.X)};
  work_->assemble(at, *curvature, target, memory.factored_tau);
  if (!work_->factor(at, memory.factored_tau)) return false;
  work_->memory = memory;
  return true;
}

StepResult TimeStepper::step(const State& old, const Target& target, double tau) {
  StepResult result;
  const Triangulation& mesh = *work_->mesh;
  const std::optional<Curvature> curvature = curvature_of(mesh, old.X);
  if (!curvature) return result;
  if (!work_->solve_coupled(old, *curvature, target, tau, result.fields)) return result;
  const StepFields& fields = result.fields;
  result.state = {old.X + fields.Y, old.beta};
  if (!(mesh_quality(mesh, result.state.X) > 0)) return result;  // a triangle is turned over
  if (has_free_order(work_->model))
    result.state.beta =
        order_step(mesh, work_->material, old, *curvature, fields.V - fields.Y / tau, tau);
  if (result.state.beta.size() == 0) return result;
  result.dissipation = dissipation_of(mesh, work_->material, old, fields, result.state.beta, tau);
  result.ok = true;
  return result;
}

}  // namespace sbeh::surface3d
