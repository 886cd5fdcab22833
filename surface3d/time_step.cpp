#include "surface3d/time_step.h"

#include "surface3d/diagnostics.h"
#include "surface3d/direct_solver.h"
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

}  // namespace

struct TimeStepper::Workspace {
  std::shared_ptr<const Triangulation> mesh;
  model::Material material;
  model::Model model;
  CoupledSystem system;
  DirectSolver flow, motion;

  bool solve_coupled(const State& old, const Curvature& curvature, const Target& target, double tau,
                     StepFields& out);
};

// False when a matrix is singular.
bool TimeStepper::Workspace::solve_coupled(const State& old, const Curvature& curvature,
                                           const Target& target, double tau, StepFields& out) {
  const double A = area(*mesh, old.X), volume_now = volume(*mesh, old.X);
  system.assemble(*mesh, old, curvature, tau,
                  {.area_rate = (target.area - A) / (tau * A),
                   .volume_rate = (target.volume - volume_now) / tau,
                   .keep_volume = !is_sphere(*mesh, A, volume_now)});
  if (!flow.factor(system.flow().matrix)) return false;
  Eigen::VectorXd solution = system.flow().rhs;
  flow.solve(solution);
  if (!solution.allFinite()) return false;
  out = {.V = system.velocity(solution),
         .Y = {},
         .H = system.curvature(solution),
         .p = system.pressure(solution),
         .lambda = system.lambda(solution)};
  if (system.scheme() == Scheme::split) {
    if (!motion.factor(system.motion().matrix)) return false;
    solution = system.motion().rhs;
    system.add_normal_motion(out.V, solution);
    motion.solve(solution);
    if (!solution.allFinite()) return false;
  }
  out.Y = system.displacement(solution);
  return true;
}

TimeStepper::TimeStepper(std::shared_ptr<const Triangulation> mesh, const model::Material& material,
                         model::Model model, Scheme scheme)
    : work_(new Workspace{.mesh = mesh,
                          .material = material,
                          .model = model,
                          .system = CoupledSystem(*mesh, material, scheme),
                          .flow = DirectSolver(Symmetry::general),
                          .motion = DirectSolver(Symmetry::symmetric)}) {}
TimeStepper::~TimeStepper() = default;
TimeStepper::TimeStepper(TimeStepper&&) noexcept = default;
TimeStepper& TimeStepper::operator=(TimeStepper&&) noexcept = default;

StepResult TimeStepper::step(const State& old, const Target& target, double tau) {
  StepResult result;
  const Triangulation& mesh = *work_->mesh;
  const std::optional<Curvature> curvature = curvature_of(mesh, old.X);
  if (!curvature) return result;
  if (!work_->solve_coupled(old, *curvature, target, tau, result.fields)) return result;
  const StepFields& fields = result.fields;
  result.state = {old.X + fields.Y, old.beta};
  if (!(mesh_quality(mesh, result.state.X) > 0)) return result;  // a triangle is turned over
  if (work_->model == model::Model::SBEH)
    result.state.beta =
        order_step(mesh, work_->material, old, *curvature, fields.V - fields.Y / tau, tau);
  if (result.state.beta.size() == 0) return result;
  result.dissipation = dissipation_of(mesh, work_->material, old, fields, result.state.beta, tau);
  result.ok = true;
  return result;
}

}  // namespace sbeh::surface3d
