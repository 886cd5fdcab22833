#include "axisym/weak_form.h"

namespace sbeh::axisym {

OrderData order_step_point(const model::Material& m, const OrderPoint& x, double tau) {
  const double K = x.H * x.geometry.B_phi - x.geometry.B_phi * x.geometry.B_phi;
  const double excess = x.H - m.spontaneous_curvature;
  const double drag = m.order_drag(), stretch = x.geometry.stretch;
  // κ' and κ_G' are linear in β: their value at β = 1 is the factor of βⁿ.
  const double reaction = m.kappa_slope(1.) / 2 * excess * excess  // (B3)
                        + m.kappa_gauss_slope(1.) * K              // (B4)
                        + m.potential.secant(x.beta_old);          // (B5)
  return {
      .matrix = {{drag / tau + reaction, drag * x.slip / stretch},  // (B1)
                 {0, m.l1() / (stretch * stretch)}},                // (B2)
      .rhs = drag * x.beta_old / tau - m.potential.slope_at_zero(),
  };
}

}  // namespace sbeh::axisym
