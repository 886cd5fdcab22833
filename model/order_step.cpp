#include "model/order_step.h"

#include "model/numerics/root.h"

#include <ceres/jet.h>
#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

namespace sbeh::model {

OrderData order_step_point(const Material& m, const OrderPoint& x, double tau) {
  const double drag = m.order_drag(x.beta);
  const double excess = x.H - m.spontaneous_curvature, splay = excess * excess / 2;
  return {
      .reaction = drag / tau                             // (B1)
                + m.kappa_secant(x.beta) * splay         // (B3)
                + m.kappa_gauss_secant(x.beta) * x.K     // (B4)
                + m.potential.secant(x.beta)             // (B5)
                + m.flexoelectric.secant(x.beta) * x.H,  // (B6)
      .advection = drag * x.slip,                        // (B1)
      .diffusion = m.l1(),                               // (B2)
      .rhs = drag * x.beta_from / tau                    // (B1)
           - m.kappa_slope_at_zero() * splay             // (B3)
           - m.kappa_gauss_slope_at_zero() * x.K         // (B4)
           - m.potential.slope_at_zero()                 // (B5)
           - m.flexoelectric.slope_at_zero() * x.H       // (B6)
           + m.packing_slope(x.beta) * x.pressure,       // (B9)
  };
}

OrderData order_force_point(const Material& m, const OrderPoint& x) {
  using Jet = ceres::Jet<double, 1>;
  const Jet force = order_force(m, Jet(x.beta, 0), Jet(x.H), Jet(x.K));  // (B3) … (B6)
  return {.reaction = force.v[0],
          .advection = Tangent<double>::Zero(),
          .diffusion = m.l1(),  // (B2)
          .rhs = force.v[0] * x.beta - force.a};
}

double conserved_order(const Material& material, double area, double start) {
  constexpr double near = 1e-5;  // nothing next to the tolerance of a step
  if (!material.mean_order) return start;
  if (!(std::abs(start / area - *material.mean_order) < near))
    throw std::invalid_argument(
        fmt::format("order = \"{}\": the start has the mean order {:.10g}, which stays, not {}: "
                    "say mean_order = "
                    "{:.10g}, or begin with another order",
                    name(material.order), start / area, *material.mean_order, start / area));
  return *material.mean_order * area;
}

std::optional<double> sphere_rest_order(const Material& material) {
  const auto force = [&](double beta) { return order_force(material, beta, -2., 1.); };
  constexpr int samples = 4096;
  for (int k = samples; k > 1; --k) {
    const double high = double(k) / samples, low = double(k - 1) / samples;
    if (force(high) >= 0 && force(low) < 0) return root_between(force, low, high).middle();
  }
  return {};
}

}  // namespace sbeh::model
