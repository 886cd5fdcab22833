// A material in which every term counts.
#pragma once

#include "model/material.h"

namespace sbeh::model::test {

/// Unequal elastic constants, residual stiffness, spontaneous curvature, flexoelectric coupling, and a potential of degree 6
/// with a linear term.
inline Material general_material() {
  return {
      .L1 = 0.05,
      .L2 = -0.013,
      .L3 = 0.031,
      .potential = Potential({0.2, -0.3, 0.7, -1.1, 0.9, 0.4, -0.25}),
      .order_viscosity = 0.4,
      .residual_stiffness = 0.02,
      .spontaneous_curvature = -0.7,
      .flexoelectric = Polynomial({0.3, -0.8, 0.5, 0.2}),
  };
}

/// The same with κ and κ_G of its own.
inline Material given_material() {
  Material material = general_material();
  material.residual_stiffness = 0;
  material.kappa_powers = Polynomial({0.3, -0.2, 0.4, 0.1});
  material.kappa_gauss_powers = Polynomial({-0.1, 0.05, -0.3, 0.2});
  return material;
}

}  // namespace sbeh::model::test
