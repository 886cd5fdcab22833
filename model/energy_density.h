// The energy per area of an ordered membrane, the single source of every force.
#pragma once

#include "model/material.h"

namespace sbeh::model {

/// Energy per area; T is double or an automatic-differentiation number.
template <class T>
struct EnergyDensity {
  T distortion;    ///< (l₁/2)|∇β|²                             (E1)
  T bending;       ///< (κ(β)/2)(H − H₀)² + f(β)H                (E2) (E5)
  T gaussian;      ///< κ_G(β) K                                 (E3)
  T thermotropic;  ///< u(β)                                     (E4)
  T total() const { return distortion + bending + gaussian + thermotropic; }
};

/// At a point with order β, |∇β|², H = tr B (−2 on the unit sphere) and Gaussian curvature K.
template <class T>
EnergyDensity<T> energy_density(const Material& material, const T& beta, const T& grad_beta_squared,
                                const T& H, const T& K) {
  const T excess = H - material.spontaneous_curvature;
  return {
      .distortion = 0.5 * material.l1() * grad_beta_squared,
      .bending = 0.5 * material.kappa(beta) * excess * excess  // (E2)
               + material.flexoelectric.value(beta) * H,       // (E5)
      .gaussian = material.kappa_gauss(beta) * K,
      .thermotropic = material.potential.value(beta),
  };
}

/// Σ n(β)/n(2/3), what a tension adds per area: Σ where all orders have the same area.
template <class T>
T tension_at(const Material& material, double tension, const T& beta) {
  return material.has_lipid_density() ? T(tension * material.packing(beta)) : T(tension);
}

}  // namespace sbeh::model
