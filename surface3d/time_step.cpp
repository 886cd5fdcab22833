#include "surface3d/time_step.h"

#include "surface3d/diagnostics.h"
#include "surface3d/linear/lagged_solver.h"
#include "surface3d/order_step.h"
#include "surface3d/parallel.h"

#include <algorithm>
#include <utility>

namespace sbeh::surface3d {

namespace {

Dissipation dissipation_of(const Triangulation& mesh, const model::Material& m, const State& old,
                           const StepFields& f, const Field& beta_new, const Field& beta_from,
                           double tau) {
  const Field rate = (beta_new - beta_from) / tau;
  const Nodes mesh_slip = f.V - f.Y / tau;
  const auto sum = integrate<3>(mesh, old.X, assembly_points(), [&](int e) {
    return [&m, velocity = on_element(mesh, e, f.V), slips = on_element(mesh, e, mesh_slip),
            beta = on_element(mesh, e, old.beta), rates = on_element(mesh, e, rate),
            beta_end = on_element(mesh, e, beta_new)](const ShapeValues& s, const SurfacePoint& p) {
      const Eigen::Vector3d V = value_at(velocity, s);
      const double V_n = V.dot(p.nu());
      const Eigen::Vector2d slip = p.frame.leftCols<2>().transpose() * value_at(slips, s);
      const double beta_dot = value_at(rates, s) + slip.dot(gradient_at(beta_end, p));
      const model::Gradient<double> grad_V = p.frame.transpose() * gradient_at(velocity, p);
      return Eigen::Array3d(
          m.friction_tangential * (V.squaredNorm() - V_n * V_n) + m.friction_normal * V_n * V_n,
          m.order_drag() * beta_dot * beta_dot,
          m.eta(value_at(beta, s)) / 2 * model::rate_of_strain(grad_V).squaredNorm());
    };
  });
  return {.friction = sum[0], .order = sum[1], .viscous = sum[2]};
}

CoupledSystem system_of(const Triangulation& mesh, const model::Material& material,
                        model::Model model, Scheme scheme) {
  const model::Material m = effective(material, model);
  const model::AreaConstraint area = area_constraint(model);
  return CoupledSystem(mesh, m, stable_scheme(m, area, scheme), area);
}

// Solutions with fresh factors are exact to rounding.
double allowed(Factorisation factorisation, double solver_tolerance) {
  return factorisation == Factorisation::every_step ? LaggedSolver::exact : solver_tolerance;
}

// Of the tangential motion of the mesh, which is no part of the shape.
double allowed_in_motion(Factorisation factorisation, double solver_tolerance) {
  constexpr double laxer = 100, most = 1e-2;
  return factorisation == Factorisation::every_step
           ? LaggedSolver::exact
           : std::max(solver_tolerance, std::min(laxer * solver_tolerance, most));
}

Constraints constraints_of(const Triangulation& mesh, const Nodes& X, const Target& target,
                           double tau) {
  const auto [A, V] = area_and_volume(mesh, X);
  return {.area_rate = (target.area - A) / (tau * A),
          .volume_rate = (target.volume - V) / tau,
          .keep_volume = !is_sphere(mesh, A, V)};
}

// Whether the layer is so much softer in one place than in another that the terms with ∇κ_G, which read
// the old surface, outweigh those with κ: see README.md.
bool has_soft_spots(const model::Material& m, const Field& beta) {
  constexpr double contrast = 0.1;
  const Field kappa = beta.unaryExpr([&m](double b) { return m.kappa(b); });
  return kappa.minCoeff() < contrast * kappa.maxCoeff();
}

// Largest change of a coordinate or of the order; lengths are of order 1.
double distance(const State& a, const State& b) {
  return std::max((a.X - b.X).cwiseAbs().maxCoeff(), (a.beta - b.beta).cwiseAbs().maxCoeff());
}

enum class Pass { first, corrected };

}  // namespace

struct TimeStepper::Workspace {
  std::shared_ptr<const Triangulation> mesh;
  model::Material material;
  model::Model model;
  Factorisation factorisation;
  CoupledSystem system;
  LaggedSolver flow, motion;
  double enough;  // a correction that changes the state by less is the last one
  StepperMemory memory;
  SolverCounts counts;

  bool worth_factoring() const;
  bool factor(const State& at, double tau);
  Solution guess(double tau, Pass pass) const;
  int solve_with_factors(Solution& x);
  StepFields fields(const Solution& x) const;
  bool solve_coupled(const State& at, double tau, Pass pass, StepFields& out);
  StepResult step(const State& at, const State& from, const Constraints& constraints, double tau,
                  Pass pass);
};

// When the next solve is likely to cost more than the mean of all since the last factorisation,
// which it was part of.
bool TimeStepper::Workspace::worth_factoring() const {
  if (memory.solves == 0 || factorisation == Factorisation::every_step) return true;
  const double all = flow.cost_of_factoring() + memory.iterations;
  return memory.last_iterations > all / memory.solves;
}

bool TimeStepper::Workspace::factor(const State& at, double tau) {
  memory.factored_at = at;
  memory.factored_tau = tau;
  memory.solves = memory.iterations = memory.last_iterations = 0;
  ++counts.factorisations;
  return flow.factor(system.flow().matrix)
      && (system.motion().matrix.rows() == 0 || motion.factor(system.motion().matrix));
}

// The last two solutions, extrapolated; of a step that is corrected, the first one.
Solution TimeStepper::Workspace::guess(double tau, Pass pass) const {
  Solution x = memory.last;
  x.tau = tau;
  if (x.flow.size() == 0 || factorisation == Factorisation::every_step)
    x = {.flow = Eigen::VectorXd::Zero(system.flow().rhs.size()),
         .motion = Eigen::VectorXd::Zero(system.motion().rhs.size()),
         .tau = tau};
  else if (pass == Pass::first && memory.before.flow.size() > 0) {
    const double r = tau / memory.last.tau;
    x.flow += r * (memory.last.flow - memory.before.flow);
    x.motion += r * (memory.last.motion - memory.before.motion);
  }
  system.scale_displacements(tau, x.flow, x.motion);
  return x;
}

// The number of times the factors of the flow were applied; 0 when that failed.
int TimeStepper::Workspace::solve_with_factors(Solution& x) {
  const int iterations = flow.solve(system.flow().matrix, system.flow().rhs, x.flow);
  if (iterations == 0 || system.motion().matrix.rows() == 0) return iterations;
  const Eigen::VectorXd rhs = system.motion_rhs(x.flow);
  return motion.solve(system.motion().matrix, rhs, x.motion) == 0 ? 0 : iterations;
}

StepFields TimeStepper::Workspace::fields(const Solution& x) const {
  return {.V = system.velocity(x.flow),
          .Y = system.displacement(x.flow, x.motion),
          .H = system.curvature(x.flow),
          .p = system.pressure(x.flow),
          .lambda = system.lambda(x.flow)};
}

// False when a matrix is singular.
bool TimeStepper::Workspace::solve_coupled(const State& at, double tau, Pass pass,
                                           StepFields& out) {
  const bool fresh = worth_factoring();
  if (fresh && !factor(at, tau)) return memory = {}, false;
  Solution x = guess(tau, pass);
  int iterations = solve_with_factors(x);
  if (iterations == 0 && !fresh && factor(at, tau)) {
    x = guess(tau, pass);
    iterations = solve_with_factors(x);
  }
  if (iterations == 0) return memory = {}, false;
  out = fields(x);
  system.scale_displacements(1 / tau, x.flow, x.motion);
  if (pass == Pass::first) memory.before = std::move(memory.last);
  memory.last = std::move(x);
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

TimeStepper::TimeStepper(const std::shared_ptr<const Triangulation>& mesh,
                         const model::Material& material, model::Model model, Scheme scheme,
                         Factorisation factorisation, double solver_tolerance)
    : work_(new Workspace{
        .mesh = mesh,
        .material = effective(material, model),
        .model = model,
        .factorisation = factorisation,
        .system = system_of(*mesh, material, model, scheme),
        .flow = LaggedSolver(Symmetry::general, allowed(factorisation, solver_tolerance)),
        .motion =
            LaggedSolver(Symmetry::symmetric, allowed_in_motion(factorisation, solver_tolerance)),
        .enough = 2 * allowed(factorisation, solver_tolerance),
        .memory = {},
        .counts = {}}) {}
TimeStepper::~TimeStepper() = default;
TimeStepper::TimeStepper(TimeStepper&&) noexcept = default;
TimeStepper& TimeStepper::operator=(TimeStepper&&) noexcept = default;

const StepperMemory& TimeStepper::memory() const { return work_->memory; }
SolverCounts TimeStepper::counts() const { return work_->counts; }

bool TimeStepper::recall(const StepperMemory& memory) {
  if (memory.solves > 0) {
    const State& at = memory.factored_at;
    const auto curvature = curvature_of(*work_->mesh, at.X);
    if (!curvature) return false;
    const Target kept{area(*work_->mesh, at.X), volume(*work_->mesh, at.X)};
    const double tau = memory.factored_tau;
    work_->system.assemble(*work_->mesh, at, *curvature, {at.X, curvature->H}, tau,
                           constraints_of(*work_->mesh, at.X, kept, tau));
    if (!work_->factor(at, memory.factored_tau)) return false;
  }
  work_->memory = memory;
  for (Solution* x : {&work_->memory.last, &work_->memory.before})
    if (x->flow.size() != work_->system.flow().rhs.size()
        || x->motion.size() != work_->system.motion().rhs.size())
      *x = {};  // of another version
  return true;
}

StepResult TimeStepper::step(const State& at, const State& from, const Target& target, double tau) {
  constexpr int most_corrections = 3;
  const Constraints constraints = constraints_of(*work_->mesh, at.X, target, tau);
  StepResult result = work_->step(at, from, constraints, tau, Pass::first);
  double change = 1;
  const bool correct = result.ok() && has_soft_spots(work_->material, at.beta);
  for (int i = 0; correct && i < most_corrections && change > work_->enough; ++i) {
    StepResult corrected = work_->step(result.state, from, constraints, tau, Pass::corrected);
    if (!corrected.ok()) return corrected;
    change = distance(result.state, corrected.state);
    result = std::move(corrected);
  }
  return result;
}

// One solve of the coupled step, with the surface and the coefficients of `at`, and of the order.
StepResult TimeStepper::Workspace::step(const State& at, const State& from,
                                        const Constraints& constraints, double tau, Pass pass) {
  StepResult result;
  const auto curvature = curvature_of(*mesh, at.X, from.X);
  if (!curvature) return result.fault = model::FlowFault::degenerate, result;
  system.assemble(*mesh, at, *curvature, {from.X, curvature->H_from}, tau, constraints);
  if (!solve_coupled(at, tau, pass, result.fields)) return result;
  const StepFields& fields = result.fields;
  result.state = {from.X + fields.Y, from.beta};
  if (!(mesh_quality(*mesh, result.state.X) > 0))  // a triangle is turned over
    return result.fault = model::FlowFault::degenerate, result;
  if (has_free_order(model))
    result.state.beta =
        order_step(*mesh, material, at, from.beta, *curvature, fields.V - fields.Y / tau, tau);
  if (result.state.beta.size() == 0) return result;
  result.dissipation =
      dissipation_of(*mesh, material, at, fields, result.state.beta, from.beta, tau);
  result.fault = model::FlowFault::none;
  return result;
}

}  // namespace sbeh::surface3d
