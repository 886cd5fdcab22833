#include "axisym/time_step.h"

#include "axisym/curvature.h"
#include "axisym/weak_form.h"

#include <cmath>
#include <utility>

namespace sbeh::axisym {

namespace {

Dissipation dissipation_of(const model::Material& m, const State& old, const StepFields& f,
                           const Nodes& slip, const Field& beta_new, double tau) {
  Dissipation d;
  const Field rate = (beta_new - old.beta) / tau;
  for_each_point(old.X, assembly_points(), [&](int e, const ShapeValues& s, const CurvePoint& p) {
    Eigen::Vector2d V = Eigen::Vector2d::Zero(), dV = V, local_slip = V;
    for (int a = 0; a < 4; ++a) {
      V += s.phi[a] * f.V.col(3 * e + a);
      dV += s.dphi[a] * f.V.col(3 * e + a);
      local_slip += s.phi[a] * slip.col(3 * e + a);
    }
    const double beta = value_at(old.beta, e, s);
    const double beta_dot =
        value_at(rate, e, s) + local_slip.dot(p.t) * slope_at(beta_new, e, s) / p.stretch;
    const double V_t = V.dot(p.t), V_n = V.dot(p.nu);
    d.friction += p.dS * (m.friction_tangential * V_t * V_t + m.friction_normal * V_n * V_n);
    d.order += p.dS * m.order_drag() * beta_dot * beta_dot;
    d.viscous += p.dS * m.eta(beta) / 2
               * model::rate_of_strain(surface_gradient<double>(p, V, dV)).squaredNorm();
  });
  return d;
}

}  // namespace

TimeStepper::TimeStepper(const model::Material& material, model::Model model, int elements)
    : material_(effective(material, model)),
      model_(model),
      coupled_(material_, area_constraint(model), elements),
      order_(material_, elements) {}

FlowStep TimeStepper::step(const State& old, const std::optional<Target>& target, double tau) {
  FlowStep result;
  const Field H = mean_curvature(old.X);
  if (H.size() == 0 || !H.allFinite()) return result;
  if (!coupled_.solve(old, H, target, tau, fields_)) return result;
  result.state = {old.X + fields_.Y, old.beta};
  result.state.X(0, 0) = result.state.X(0, old.X.cols() - 1) = 0;  // exactly
  const Nodes slip = fields_.V - fields_.Y / tau;
  if (has_free_order(model_)) {
    Field beta = order_.solve(old, {.H = H,
                                    .slip = slip,
                                    .next = result.state.X,
                                    .tau = tau,
                                    .total = target ? target->order : std::nullopt});
    if (beta.size() == 0) return result;
    result.state.beta = std::move(beta);
  }
  result.dissipation = dissipation_of(material_, old, fields_, slip, result.state.beta, tau);
  const double order = result.dissipation.order;  // as of an order that relaxes
  if (material_.order == model::OrderDynamics::diffusive)
    result.dissipation.order = order_.diffusion();
  result.fault = model::FlowFault::none;
  result.lambda = fields_.lambda;
  result.speed_max = fields_.V.colwise().norm().maxCoeff();
  result.order_speed = std::sqrt(order / (material_.order_drag() * area(old.X)));
  return result;
}

}  // namespace sbeh::axisym
