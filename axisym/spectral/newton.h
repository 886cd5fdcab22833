// Minima of the energy of spectral curves at fixed area and volume, by Newton's method.
#pragma once

#include "axisym/spectral/lagrangian.h"

namespace sbeh::axisym::spectral {

/// A critical point that is a minimum.
struct Critical {
  Eigen::VectorXd y;
  Multipliers multipliers;
  double energy;
  double residual;  ///< largest of the misses of the measures and of ∂𝓛/∂(n-th mode)/(1 + n)
  double stiffness;  ///< smallest eigenvalue of the second variation at fixed measures, > 0
};

/// Minimises U at these measures, starting from y. Empty unless it ends in a minimum, to rounding
/// (residual < 1e-10).
std::optional<Critical> minimise(const Problem& problem, const Eigen::VectorXd& target,
                                 Eigen::VectorXd y);

}  // namespace sbeh::axisym::spectral
