// What is measured on a surface by either solver: its energy and the rates at which that is dissipated, split
// as they are reported, its geometry and its order.
#pragma once

#include <limits>

namespace sbeh::model {

/// Integrals of the energy density over the surface, dimensionless.
struct Energy {
  double distortion = 0;    ///< ∫ (l₁/2)|∇β|²
  double bending = 0;       ///< ∫ (κ/2)(H − H₀)² + κ_G K
  double thermotropic = 0;  ///< ∫ u(β)
  double total() const { return distortion + bending + thermotropic; }
};

/// Rates of dissipation: dU/dt = −(friction + order + viscous).
struct Dissipation {
  double friction = 0;  ///< ∫ γ_∥|PV|² + γ_⊥(V·ν)² dS
  double order = 0;     ///< ∫ (3/2)(M + μξ²/2) β̇² dS
  double viscous = 0;   ///< ∫ (η/2)|σ(V)|² dS
  double total() const { return friction + order + viscous; }
};
inline Dissipation combine(double a, const Dissipation& x, double b, const Dissipation& y) {
  return {a * x.friction + b * y.friction, a * x.order + b * y.order,
          a * x.viscous + b * y.viscous};
}

/// Integrated and extreme values of a state, NaN until they are known; lengths in radii of the sphere of
/// equal area.
struct Diagnostics {
  static constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

  Energy energy;
  double area = unknown, volume = unknown, reduced_volume = unknown;
  double W2 = unknown;  ///< ∫ H dS, −8π on the unit sphere
  double order_min = unknown, order_mean = unknown, order_max = unknown;
  double order_variance = unknown;  ///< (1/A)∫(β − mean)² dS
  double order_std = unknown;       ///< its root
  double H_abs_max = unknown;       ///< largest |H|
  double mesh_quality = unknown;    ///< see the solver's
};

}  // namespace sbeh::model
