#include "surface3d/time_step.h"

#include "model/numerics/fixed_point.h"
#include "surface3d/lipids.h"
#include "surface3d/order_step.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace sbeh::surface3d {

namespace {

Constraints constraints_of(const Triangulation& mesh, const model::Material& material,
                           const State& at, const std::optional<Target>& target, double tau) {
  Target now = area_and_volume(mesh, at.X);
  const double A = now.area;
  if (material.has_lipid_density()) now = lipids_and_volume(mesh, material, at);
  const Target wanted = target.value_or(now);
  return {.area_rate = (wanted.area - now.area) / (tau * A),
          .volume_rate = (wanted.volume - now.volume) / tau,
          .keep_volume = !is_sphere(mesh, A, now.volume),
          .area = A};
}

// Whether the layer is so much softer in one place than in another that the terms with ∇κ_G, which read
// the old surface, outweigh those with κ: see README.md.
bool has_soft_spots(const model::Material& m, const Field& beta) {
  constexpr double contrast = 0.1;
  const Field kappa = beta.unaryExpr([&m](double b) { return m.kappa(b); });
  return kappa.minCoeff() < contrast * kappa.maxCoeff();
}

// Of the change of ∫ n dS of a piece, by solutions that are not better than their tolerance.
model::FixedPointTolerance together(double solver_tolerance, double tau) {
  constexpr double more = 10, rounding = 1e-12;
  return {.relative = std::max(more * solver_tolerance, 1e-9), .absolute = rounding / tau};
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
      solver_(numerics, mesh->ranks) {}

bool TimeStepper::recall(const StepperMemory& memory) {
  if (memory.solves > 0) {
    const State& at = memory.factored_at;
    const auto curvature = curvature_of(*mesh_, at.X);
    if (!curvature) return false;
    const double tau = memory.factored_tau;
    const Field no_force = Field::Zero(mesh_->nodes);  // the factors do not know it
    system_.assemble(*mesh_, at, *curvature, no_force, {at.X, curvature->H}, tau,
                     constraints_of(*mesh_, material_, at, {}, tau));
  }
  return solver_.recall(system_, memory);
}

FlowStep TimeStepper::step(const State& at, const State& from, const std::optional<Target>& target,
                           double tau) {
  total_order_ = target ? target->order : std::nullopt;
  constexpr int most_corrections = 3;
  const Constraints constraints = constraints_of(*mesh_, material_, at, target, tau);
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

// The order step with the fields of the coupled one.
OrderStepResult TimeStepper::order_after(const State& at, const State& from,
                                         const Curvature& curvature, double tau) const {
  if (!has_free_order(model_)) return {.beta = from.beta};
  const Nodes slip = fields_.V - fields_.Y / tau, next = from.X + fields_.Y;
  return order_step(*mesh_, material_, at,
                    {.curvature = curvature,
                     .slip = slip,
                     .from = from.beta,
                     .next = next,
                     .tau = tau,
                     .total = total_order_,
                     .p = &fields_.p});
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
  OrderStepResult order;
  Nodes slip;
  Field order_rate;
  const Motion motion{fields_.V, slip, order_rate, order.beta};
  const auto advance = [&] {
    const auto solution = solver_.solve(system_, at, tau, pass);
    if (!solution) return false;
    pass = Pass::corrected;
    fields_ = fields_of(*solution);
    order = order_after(at, from, *curvature, tau);
    if (order.beta.size() == 0) return false;
    slip = fields_.V - fields_.Y / tau;
    order_rate = (order.beta - from.beta) / tau;
    return true;
  };
  // The order moves the lipids, and their pressure the order.
  const auto load = [&](const Field& lipids) -> Field {
    system_.set_lipids(lipids);
    return advance() ? lipid_load(*mesh_, material_, at, motion) : Field();
  };
  Field lipids = Field::Zero(mesh_->quadratic_nodes);
  if (!(material_.has_lipid_density()
            ? model::find_fixed_point(load, together(solver_.solver_tolerance(), tau), lipids)
            : advance()))
    return {};
  return result_of(at, from, order, motion);
}

FlowStep TimeStepper::result_of(const State& at, const State& from, const OrderStepResult& order,
                                const Motion& motion) const {
  State next{from.X + fields_.Y, order.beta};
  if (!(mesh_quality(*mesh_, next.X) > 0))  // a triangle is turned over
    return {.fault = model::FlowFault::degenerate};
  Dissipation dissipation = dissipation_of(*mesh_, material_, at, motion);
  const double of_order = dissipation.order;  // as of an order that relaxes
  if (material_.order == model::OrderDynamics::diffusive) dissipation.order = order.diffusion;
  return {.fault = model::FlowFault::none,
          .state = std::move(next),
          .dissipation = dissipation,
          .lambda = fields_.lambda,
          .speed_max = fields_.V.colwise().norm().maxCoeff(),
          .order_speed = std::sqrt(of_order / (material_.order_drag() * area(*mesh_, at.X)))};
}

}  // namespace sbeh::surface3d
