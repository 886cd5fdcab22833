#include "axisym/time_step.h"

#include "axisym/curvature.h"
#include "axisym/lipids.h"
#include "axisym/weak_form.h"
#include "model/numerics/fixed_point.h"

#include <cmath>
#include <utility>

namespace sbeh::axisym {

namespace {

// Of the change of ∫ n dS of a piece: less than a step's own error by far, more than rounding makes of what is over τ.
model::FixedPointTolerance together(double tau) {
  return {.relative = 1e-9, .absolute = 1e-12 / tau};
}

Dissipation dissipation_of(const model::Material& m, const State& old, const StepFields& f,
                           const Nodes& slip, const Field& beta_new, double tau) {
  Dissipation d;
  const Field change = (beta_new - old.beta) / tau;
  const OrderRate rate{change, slip, beta_new};
  for_each_point(old.X, assembly_points(), [&](int e, const ShapeValues& s, const CurvePoint& p) {
    Eigen::Vector2d V = Eigen::Vector2d::Zero(), dV = V;
    for (int a = 0; a < 4; ++a) {
      V += s.phi[a] * f.V.col(3 * e + a);
      dV += s.dphi[a] * f.V.col(3 * e + a);
    }
    const double beta = value_at(old.beta, e, s), beta_dot = rate.at(e, s, p);
    const double V_t = V.dot(p.t), V_n = V.dot(p.nu);
    d.friction += p.dS * (m.friction_tangential * V_t * V_t + m.friction_normal * V_n * V_n);
    d.order += p.dS * m.order_drag(beta) * beta_dot * beta_dot;
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

// The coupled step, with what (P1) has of the order, and then the order; without an order where a matrix is singular.
State TimeStepper::once(const State& old, const Field& H, const Field& lipids,
                        std::optional<double> total, double tau) {
  if (!coupled_.solve(lipids, fields_)) return {};
  State next{old.X + fields_.Y, old.beta};
  next.X(0, 0) = next.X(0, old.X.cols() - 1) = 0;  // exactly
  if (!has_free_order(model_)) return next;
  const Nodes slip = fields_.V - fields_.Y / tau;
  next.beta = order_.solve(
      old, {.H = H, .slip = slip, .next = next.X, .p = fields_.p, .tau = tau, .total = total});
  return next;
}

Field TimeStepper::lipids_of(const State& old, const Field& beta, double tau) const {
  const Nodes slip = fields_.V - fields_.Y / tau;
  const Field change = (beta - old.beta) / tau;
  return lipid_load(material_, old, {change, slip, beta});
}

FlowStep TimeStepper::step(const State& old, const std::optional<Target>& target, double tau) {
  FlowStep result;
  const Field H = mean_curvature(old.X);
  if (H.size() == 0 || !H.allFinite()) return result;
  if (!coupled_.prepare(old, H, target, tau)) return result;
  const std::optional<double> total = target ? target->order : std::nullopt;
  Field lipids = Field::Zero(2 * element_count(old.X) + 1);  // what (P1) has of the order
  const auto advance = [&](const Field& of_order) {
    result.state = once(old, H, of_order, total, tau);
    return result.state.beta.size() > 0;
  };
  // The order moves the lipids, and their pressure the order.
  const auto load = [&](const Field& of_order) -> Field {
    return advance(of_order) ? lipids_of(old, result.state.beta, tau) : Field();
  };
  if (!(material_.has_lipid_density() ? model::find_fixed_point(load, together(tau), lipids)
                                      : advance(lipids)))
    return result;
  const Nodes slip = fields_.V - fields_.Y / tau;
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
