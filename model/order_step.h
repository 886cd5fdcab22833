// The order equation of one time step at a point.
#pragma once

#include "model/terms.h"

namespace sbeh::model {

/// What the order step reads at a point: the order at which the potential is linearised and the one
/// from which the step begins (the same but for two-step methods), curvatures, and the velocity of the
/// material relative to the mesh, the tangential part of V − Y/τ.
struct OrderPoint {
  double beta, beta_old, H, K;
  Tangent<double> slip;
};

/// (B1)–(B5), linear in β. The potential enters as u'(0) + [(u'(β*) − u'(0))/β*] βⁿ,
/// linearised at β* = `beta`.
struct OrderData {
  double reaction;            ///< of (β, ψ)
  Tangent<double> advection;  ///< of (∇β, ψ)
  double diffusion;           ///< of (∇β, ∇ψ)
  double rhs;                 ///< of ψ
};
OrderData order_step_point(const Material& m, const OrderPoint& x, double tau);

}  // namespace sbeh::model
