// What is measured on a state: energy and its parts, geometry, order.
#pragma once

#include "axisym/curve.h"
#include "model/material.h"

namespace sbeh::axisym {

/// Integrals of the energy density over the surface, dimensionless.
struct Energy {
  double distortion = 0;    ///< ∫ (l₁/2)|∇β|²
  double bending = 0;       ///< ∫ (κ/2)(H − H₀)² + κ_G K
  double thermotropic = 0;  ///< ∫ u(β)
  double total() const { return distortion + bending + thermotropic; }
};

/// Energy of a state whose nodal mean curvature is known.
Energy energy(const model::Material& material, const State& state, const Field& H);

/// Integrated and extreme values of a state; lengths in radii of the sphere of equal area.
struct Diagnostics {
  Energy energy;
  double area, volume, reduced_volume;
  double W2;  ///< ∫ H dS, −8π on the unit sphere
  double order_min, order_mean, order_max;
  double order_variance;  ///< (1/A)∫(β − mean)² dS
  double order_std;       ///< its root
  double H_pole;          ///< at the north pole, extrapolated from beyond the pole's element
  double H_rim;           ///< where r is largest
  double H_abs_max;       ///< largest |H|
  double radius_equator;  ///< largest r
  double thickness_pole;  ///< distance of the poles along the axis
  double rim_resolution;  ///< largest |H| · (node spacing): above about 0.5 a rim is not resolved
  double mesh_quality;    ///< shortest over longest element
};
Diagnostics diagnose(const model::Material& material, const State& state);

}  // namespace sbeh::axisym
