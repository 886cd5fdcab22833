// A membrane whose order separates into two phases.
#pragma once

#include "model/material.h"

namespace sbeh::model::test {

inline constexpr double poor = 0.1, rich = 0.6;

/// u = c (β − poor)²(β − rich)²; stiffnesses of half and of twice those of the poor phase in the rich one.
inline Material two_phases(double L, double c, double mean, OrderDynamics dynamics) {
  const double s = poor + rich, p = poor * rich;
  Material material;
  material.L1 = L;
  material.potential = Potential({c * p * p, -2 * c * s * p, c * (s * s + 2 * p), -2 * c * s, c});
  material.kappa_powers = Polynomial({0.08, 0.1});
  material.kappa_gauss_powers = Polynomial({-0.05, -0.05});
  material.order = dynamics;
  material.mean_order = mean;
  return material;
}

/// ∫√(2 l₁ u) dβ between the phases.
inline double line_tension(double L, double c) {
  const double gap = rich - poor;
  return std::sqrt(2 * 1.5 * L * c) * gap * gap * gap / 6;
}

}  // namespace sbeh::model::test
