// The order equation at a point: over one time step, and at rest on a unit sphere.
#pragma once

#include "model/terms.h"

#include <optional>

namespace sbeh::model {

/// What the order step reads at a point: the order at which the potential is linearised and the one
/// from which the step begins (the same but for two-step methods), curvatures, and the velocity of the
/// material relative to the mesh, the tangential part of V − Y/τ.
struct OrderPoint {
  double beta, beta_from, H, K;
  Tangent<double> slip;
  double pressure = 0;  ///< p of (P1) over n/n(2/3), of a membrane with lipid_density
};

/// (B1)–(B6) and (B9), linear in β. The potential enters as u'(0) + [(u'(β*) − u'(0))/β*] βⁿ, linearised at β* = `beta`, and κ, κ_G, f likewise.
struct OrderData {
  double reaction;            ///< of (β, ψ)
  Tangent<double> advection;  ///< of (∇β, ψ)
  double diffusion;           ///< of (∇β, ∇ψ)
  double rhs;                 ///< of ψ
};
OrderData order_step_point(const Material& m, const OrderPoint& x, double tau);
/// (B2)–(B6) of it, without what resists, and linearised at β* as a whole: without it, the step above is no contraction.
OrderData order_force_point(const Material& m, const OrderPoint& x);

/// What is said of a flow that begins there with a lipid_density.
inline constexpr const char* no_lipids_on_spheres =
    "lipid_density: the start is a sphere, whose area cannot grow with that of its lipids";

/// The ∫β dS that a flow with this area keeps: by its mean order, or where that is not given the start's. Throws std::invalid_argument
/// where the start has another mean than the one given.
double conserved_order(const Material& material, double area, double start);

/// Largest β in (0, 1] with (κ'/2)(H − H₀)² + κ_G' K + f' H + u' = 0 at H = −2, K = 1 and rising there: the
/// rest state of a uniform order on the unit sphere. Paper's potential: larger root of
/// 60.75β² − 40.5β + 9L = 0. Empty when only the disordered state is left (L > 0.75 there).
std::optional<double> sphere_rest_order(const Material& material);

}  // namespace sbeh::model
