#include "model/order_step.h"

namespace sbeh::model {

OrderData order_step_point(const Material& m, const OrderPoint& x, double tau) {
  const double excess = x.H - m.spontaneous_curvature;
  const double drag = m.order_drag();
  // κ' and κ_G' are linear in β: their value at β = 1 is the factor of βⁿ.
  return {
      .reaction = drag / tau                               // (B1)
                + m.kappa_slope(1.) / 2 * excess * excess  // (B3)
                + m.kappa_gauss_slope(1.) * x.K            // (B4)
                + m.potential.secant(x.beta),              // (B5)
      .advection = drag * x.slip,                          // (B1)
      .diffusion = m.l1(),                                 // (B2)
      .rhs = drag * x.beta_old / tau                       // (B1)
           - m.potential.slope_at_zero(),                  // (B5)
  };
}

}  // namespace sbeh::model
