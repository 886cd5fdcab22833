#include "axisym/order_step.h"

#include "axisym/curvature.h"
#include "axisym/weak_form.h"
#include "model/order_step.h"

namespace sbeh::axisym {

namespace {

model::OrderPoint order_point(const State& old, const OrderStepData& step, int e,
                              const ShapeValues& s, const CurvePoint& p) {
  double slip_t = 0;
  for (int a = 0; a < 4; ++a) slip_t += s.phi[a] * step.slip.col(3 * e + a).dot(p.t);
  double pressure = 0;
  for (int k = 0; k < 3; ++k) pressure += s.phi2[std::size_t(k)] * step.p[2 * e + k];
  const double h = value_at(step.H, e, s), beta = value_at(old.beta, e, s);
  return {.beta = beta,
          .beta_from = beta,
          .H = h,
          .K = gauss_curvature(h, p.B_phi),
          .slip = {slip_t, 0},
          .pressure = pressure};
}

// ∫φ_i dS
Field weights_of(const Nodes& X) {
  Field weights = Field::Zero(X.cols());
  for_each_point(X, assembly_points(), [&](int e, const ShapeValues& s, const CurvePoint& p) {
    for (int a = 0; a < 4; ++a) weights[3 * e + a] += p.dS * s.phi[a];
  });
  return weights;
}

}  // namespace

OrderStep::OrderStep(const model::Material& material, int elements)
    : material_(material),
      diffuses_(material.order == model::OrderDynamics::diffusive),
      matrix_((diffuses_ ? 2 : 1) * (3 * elements + 1), diffuses_ ? 7 : 3) {}

Field OrderStep::solve(const State& old, const OrderStepData& step) {
  return diffuses_ ? diffused(old, step) : relaxed(old, step);
}

Field OrderStep::relaxed(const State& old, const OrderStepData& step) {
  matrix_.set_zero();
  // The order without a chemical potential, and how it responds to one.
  Eigen::MatrixXd columns =
      Eigen::MatrixXd::Zero(old.beta.size(), material_.conserves_order() ? 2 : 1);
  for_each_point(old.X, assembly_points(), [&](int e, const ShapeValues& s, const CurvePoint& p) {
    const model::OrderData d =
        model::order_step_point(material_, order_point(old, step, e, s, p), step.tau);
    const double advection = d.advection[0] / p.stretch;
    const double diffusion = d.diffusion / (p.stretch * p.stretch);
    for (int a = 0; a < 4; ++a) {
      columns(3 * e + a, 0) += p.dS * d.rhs * s.phi[a];
      if (columns.cols() > 1) columns(3 * e + a, 1) += p.dS * s.phi[a];  // (B7)
      for (int b = 0; b < 4; ++b)
        matrix_(3 * e + a, 3 * e + b) +=
            p.dS
            * (d.reaction * s.phi[a] * s.phi[b] + advection * s.phi[a] * s.dphi[b]
               + diffusion * s.dphi[a] * s.dphi[b]);
    }
  });
  if (!matrix_.factor()) return {};
  matrix_.solve(columns);
  if (!columns.allFinite()) return {};
  if (columns.cols() == 1) return columns.col(0);
  const Field weights = weights_of(step.next);
  const double total = step.total ? *step.total : weights_of(old.X).dot(old.beta);
  const double mu = (total - weights.dot(columns.col(0))) / weights.dot(columns.col(1));
  return columns.col(0) + mu * columns.col(1);
}

// (β̇, ψ) + (M_β ∇μ, ∇ψ) = 0 and (μ, χ) = (δU/δβ, χ): unknowns β, μ, node by node.
Field OrderStep::diffused(const State& old, const OrderStepData& step) {
  const double mobility = material_.order_mobility.value_or(1);
  matrix_.set_zero();
  Eigen::VectorXd x = Eigen::VectorXd::Zero(matrix_.size());
  for_each_point(old.X, assembly_points(), [&](int e, const ShapeValues& s, const CurvePoint& p) {
    const model::OrderPoint at = order_point(old, step, e, s, p);
    const model::OrderData d = model::order_force_point(material_, at);
    const double slip = at.slip[0] / p.stretch, square = p.stretch * p.stretch;
    for (int a = 0; a < 4; ++a) {
      const int beta = 2 * (3 * e + a), mu = beta + 1;
      x[beta] += p.dS * at.beta_from / step.tau * s.phi[a];
      x[mu] += p.dS * d.rhs * s.phi[a];
      for (int b = 0; b < 4; ++b) {
        const int of_beta = 2 * (3 * e + b), of_mu = of_beta + 1;
        const double mass = p.dS * s.phi[a] * s.phi[b],
                     stiffness = p.dS * s.dphi[a] * s.dphi[b] / square;
        matrix_(beta, of_beta) += mass / step.tau + p.dS * slip * s.phi[a] * s.dphi[b];  // (B8)
        matrix_(beta, of_mu) += mobility * stiffness;                                    // (B8)
        matrix_(mu, of_beta) += d.reaction * mass + d.diffusion * stiffness;
        matrix_(mu, of_mu) -= mass;
      }
    }
  });
  if (!matrix_.factor()) return {};
  matrix_.solve(x);
  if (!x.allFinite()) return {};
  const Field mu = x(Eigen::seqN(1, old.beta.size(), 2));
  diffusion_ = 0;
  for_each_point(old.X, assembly_points(), [&](int e, const ShapeValues& s, const CurvePoint& p) {
    const double slope = slope_at(mu, e, s) / p.stretch;
    diffusion_ += p.dS * mobility * slope * slope;
  });
  return x(Eigen::seqN(0, old.beta.size(), 2));
}

}  // namespace sbeh::axisym
