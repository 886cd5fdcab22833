#include "surface3d/time_step.h"

#include "surface3d/dissipation.h"
#include "surface3d/order_step.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace sbeh::surface3d {

namespace {

Constraints constraints_of(const Triangulation& mesh, const Nodes& X,
                           const std::optional<Target>& target, double tau) {
  const Target now = area_and_volume(mesh, X), wanted = target.value_or(now);
  return {.area_rate = (wanted.area - now.area) / (tau * now.area),
          .volume_rate = (wanted.volume - now.volume) / tau,
          .keep_volume = !is_sphere(mesh, now.area, now.volume),
          .area = now.area};
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
                         const model::Material& material, model::Model model,
                         const Numerics& numerics)
    : mesh_(mesh),
      material_(effective(material, model)),
      model_(model),
      system_(*mesh, material_, numerics.scheme, area_constraint(model)),
      solver_(numerics) {}

bool TimeStepper::recall(const StepperMemory& memory) {
  if (memory.solves > 0) {
    const State& at = memory.factored_at;
    const auto curvature = curvature_of(*mesh_, at.X);
    if (!curvature) return false;
    const double tau = memory.factored_tau;
    const Field no_force = Field::Zero(mesh_->nodes);  // the factors do not know it
    system_.assemble(*mesh_, at, *curvature, no_force, {at.X, curvature->H}, tau,
                     constraints_of(*mesh_, at.X, {}, tau));
  }
  return solver_.recall(system_, memory);
}

FlowStep TimeStepper::step(const State& at, const State& from, const std::optional<Target>& target,
                           double tau) {
  total_order_ = target ? target->order : std::nullopt;
  constexpr int most_corrections = 3;
  const Constraints constraints = constraints_of(*mesh_, at.X, target, tau);
  FlowStep result = solve(at, from, constraints, tau, Pass::first);
  double change = 1;
  const bool correct = result.ok() && has_soft_spots(material_, at.beta);
  for (int i = 0; correct && i < most_corrections && change > 2 * solver_.solver_tolerance(); ++i) {
    FlowStep corrected = solve(result.state, from, constraints, tau, Pass::corrected);
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
FlowStep TimeStepper::solve(const State& at, const State& from, const Constraints& constraints,
                            double tau, Pass pass) {
  const auto curvature = curvature_of(*mesh_, at.X, &from.X);
  if (!curvature) return {.fault = model::FlowFault::degenerate};
  Field force = has_free_order(model_) ? order_force(*mesh_, material_, at, *curvature)
                                       : Field::Zero(mesh_->nodes);
  if (force.size() == 0) return {};
  if (material_.conserves_order()) {
    // What p would take up but for the elements: at rest h is μ_β everywhere.
    const double mu = total_order(*mesh_, {at.X, force}) / constraints.area;
    force.array() -= mu;
    system_.set_material(material_.at_chemical_potential(mu));
  }
  system_.assemble(*mesh_, at, *curvature, force, {from.X, curvature->H_from}, tau, constraints);
  const auto solution = solver_.solve(system_, at, tau, pass);
  if (!solution) return {};
  fields_ = fields_of(*solution);
  State next{from.X + fields_.Y, from.beta};
  if (!(mesh_quality(*mesh_, next.X) > 0))  // a triangle is turned over
    return {.fault = model::FlowFault::degenerate};
  const Nodes slip = fields_.V - fields_.Y / tau;
  double diffusion = 0;
  if (has_free_order(model_)) {
    OrderStepResult order = order_step(*mesh_, material_, at,
                                       {.curvature = *curvature,
                                        .slip = slip,
                                        .from = from.beta,
                                        .next = next.X,
                                        .tau = tau,
                                        .total = total_order_});
    next.beta = std::move(order.beta);
    diffusion = order.diffusion;
  }
  if (next.beta.size() == 0) return {};
  Dissipation dissipation = dissipation_of(*mesh_, material_, at,
                                           {.velocity = fields_.V,
                                            .slip = slip,
                                            .order_rate = (next.beta - from.beta) / tau,
                                            .order = next.beta});
  const double order = dissipation.order;  // as of an order that relaxes
  if (material_.order == model::OrderDynamics::diffusive) dissipation.order = diffusion;
  return {.fault = model::FlowFault::none,
          .state = next,
          .dissipation = dissipation,
          .lambda = fields_.lambda,
          .speed_max = fields_.V.colwise().norm().maxCoeff(),
          .order_speed = std::sqrt(order / (material_.order_drag() * area(*mesh_, at.X)))};
}

}  // namespace sbeh::surface3d
