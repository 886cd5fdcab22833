#include "surface3d/time_step.h"

#include "surface3d/diagnostics.h"
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

}  // namespace

TimeStepper::TimeStepper(const std::shared_ptr<const Triangulation>& mesh,
                         const model::Material& material, model::Model model, Scheme scheme,
                         Factorisation factorisation, double solver_tolerance)
    : mesh_(mesh),
      material_(effective(material, model)),
      model_(model),
      system_(*mesh, material_, stable_scheme(material_, area_constraint(model), scheme),
              area_constraint(model)),
      solver_(factorisation, solver_tolerance) {}

bool TimeStepper::recall(const StepperMemory& memory) {
  if (memory.solves > 0) {
    const State& at = memory.factored_at;
    const auto curvature = curvature_of(*mesh_, at.X);
    if (!curvature) return false;
    const double tau = memory.factored_tau;
    system_.assemble(*mesh_, at, *curvature, {at.X, curvature->H}, tau,
                     constraints_of(*mesh_, at.X, area_and_volume(*mesh_, at.X), tau));
  }
  return solver_.recall(system_, memory);
}

StepResult TimeStepper::step(const State& at, const State& from, const Target& target, double tau) {
  constexpr int most_corrections = 3;
  const Constraints constraints = constraints_of(*mesh_, at.X, target, tau);
  StepResult result = solve(at, from, constraints, tau, Pass::first);
  double change = 1;
  const bool correct = result.ok() && has_soft_spots(material_, at.beta);
  for (int i = 0; correct && i < most_corrections && change > 2 * solver_.tolerance(); ++i) {
    StepResult corrected = solve(result.state, from, constraints, tau, Pass::corrected);
    if (!corrected.ok()) return corrected;
    change = distance(result.state, corrected.state);
    result = std::move(corrected);
  }
  return result;
}

StepFields TimeStepper::fields_of(const Solution& x) const {
  return {.V = system_.velocity(x.flow),
          .Y = system_.displacement(x.flow, x.motion),
          .H = system_.curvature(x.flow),
          .p = system_.pressure(x.flow),
          .lambda = system_.lambda(x.flow)};
}

// The coupled step, with the surface and the coefficients of `at`, and the order step.
StepResult TimeStepper::solve(const State& at, const State& from, const Constraints& constraints,
                              double tau, Pass pass) {
  StepResult result;
  const auto curvature = curvature_of(*mesh_, at.X, &from.X);
  if (!curvature) return result.fault = model::FlowFault::degenerate, result;
  system_.assemble(*mesh_, at, *curvature, {from.X, curvature->H_from}, tau, constraints);
  const auto solution = solver_.solve(system_, at, tau, pass);
  if (!solution) return result;
  result.fields = fields_of(*solution);
  const StepFields& fields = result.fields;
  result.state = {from.X + fields.Y, from.beta};
  if (!(mesh_quality(*mesh_, result.state.X) > 0))  // a triangle is turned over
    return result.fault = model::FlowFault::degenerate, result;
  if (has_free_order(model_))
    result.state.beta =
        order_step(*mesh_, material_, at, from.beta, *curvature, fields.V - fields.Y / tau, tau);
  if (result.state.beta.size() == 0) return result;
  result.dissipation =
      dissipation_of(*mesh_, material_, at, fields, result.state.beta, from.beta, tau);
  result.fault = model::FlowFault::none;
  return result;
}

}  // namespace sbeh::surface3d
