// What is measured on a state: energy and its parts, geometry, order.
#pragma once

#include "model/material.h"
#include "surface3d/curvature.h"

namespace sbeh::surface3d {

/// Integrals of the energy density over the surface, dimensionless.
struct Energy {
  double distortion = 0;    ///< ∫ (l₁/2)|∇β|²
  double bending = 0;       ///< ∫ (κ/2)(H − H₀)² + κ_G K
  double thermotropic = 0;  ///< ∫ u(β)
  double total() const { return distortion + bending + thermotropic; }
};

/// Energy of a state whose curvature is known.
Energy energy(const Triangulation& mesh, const model::Material& material, const State& state,
              const Curvature& curvature);

}  // namespace sbeh::surface3d
