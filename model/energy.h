// The energy of a surface and the rates at which it is dissipated, split as they are reported.
#pragma once

#include <cmath>

namespace sbeh::model {

/// Integrals of the energy density over the surface, dimensionless. Unlike EnergyDensity's the bending part
/// contains the Gaussian one.
struct Energy {
  double distortion = 0;       ///< ∫ (l₁/2)|∇β|²              (E1)
  double bending = 0;          ///< ∫ (κ/2)(H − H₀)² + κ_G K   (E2) + (E3)
  double thermotropic = 0;     ///< ∫ u(β)                     (E4)
  double area_difference = 0;  ///< (k_ad π/(2A))(W₂ − W₂⁰)², 0 where k_ad is infinite
  double total() const { return distortion + bending + thermotropic + area_difference; }
  double magnitude() const {
    return std::abs(distortion) + std::abs(bending) + std::abs(thermotropic)
         + std::abs(area_difference);
  }
};

/// Rates of dissipation: dU/dt = −(friction + order + viscous).
struct Dissipation {
  double friction = 0;  ///< ∫ γ_∥|PV|² + γ_⊥(V·ν)² dS
  double order = 0;     ///< ∫ m_β β̇² dS
  double viscous = 0;   ///< ∫ (η/2)|σ(V)|² dS
  double total() const { return friction + order + viscous; }
};
inline Dissipation combine(double a, const Dissipation& x, double b, const Dissipation& y) {
  return {a * x.friction + b * y.friction, a * x.order + b * y.order,
          a * x.viscous + b * y.viscous};
}

}  // namespace sbeh::model
