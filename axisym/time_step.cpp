#include "axisym/time_step.h"

#include "axisym/curvature.h"
#include "axisym/weak_form.h"
#include "model/order_step.h"

#include <cmath>

namespace sbeh::axisym {

bool TimeStepper::solve_order(const State& old, const Field& H, const Nodes& slip, double tau,
                              Field& beta) {
  order_.set_zero();
  beta = Field::Zero(old.beta.size());
  for_each_point(old.X, assembly_points(), [&](int e, const ShapeValues& s, const CurvePoint& p) {
    double slip_t = 0;
    for (int a = 0; a < 4; ++a) slip_t += s.phi[a] * slip.col(3 * e + a).dot(p.t);
    const double h = value_at(H, e, s);
    const double beta_from = value_at(old.beta, e, s);
    const model::OrderData d = model::order_step_point(material_,
                                                       {.beta = beta_from,
                                                        .beta_from = beta_from,
                                                        .H = h,
                                                        .K = gauss_curvature(h, p.B_phi),
                                                        .slip = {slip_t, 0}},
                                                       tau);
    const double advection = d.advection[0] / p.stretch;
    const double diffusion = d.diffusion / (p.stretch * p.stretch);
    for (int a = 0; a < 4; ++a) {
      beta[3 * e + a] += p.dS * d.rhs * s.phi[a];
      for (int b = 0; b < 4; ++b)
        order_(3 * e + a, 3 * e + b) +=
            p.dS
            * (d.reaction * s.phi[a] * s.phi[b] + advection * s.phi[a] * s.dphi[b]
               + diffusion * s.dphi[a] * s.dphi[b]);
    }
  });
  if (!order_.factor()) return false;
  order_.solve(beta);
  return beta.allFinite();
}

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
      order_(3 * elements + 1, 3) {}

FlowStep TimeStepper::step(const State& old, const std::optional<Target>& target, double tau) {
  FlowStep result;
  const Field H = mean_curvature(old.X);
  if (H.size() == 0 || !H.allFinite()) return result;
  if (!coupled_.solve(old, H, target, tau, fields_)) return result;
  result.state = {old.X + fields_.Y, old.beta};
  result.state.X(0, 0) = result.state.X(0, old.X.cols() - 1) = 0;  // exactly
  const Nodes slip = fields_.V - fields_.Y / tau;
  if (has_free_order(model_) && !solve_order(old, H, slip, tau, result.state.beta)) return result;
  result.dissipation = dissipation_of(material_, old, fields_, slip, result.state.beta, tau);
  result.fault = model::FlowFault::none;
  result.lambda = fields_.lambda;
  result.speed_max = fields_.V.colwise().norm().maxCoeff();
  result.order_speed = std::sqrt(result.dissipation.order / (material_.order_drag() * area(old.X)));
  return result;
}

}  // namespace sbeh::axisym
