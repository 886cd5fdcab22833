// Minima and other critical points of the energy of spectral curves at given measures, by Newton's method.
#pragma once

#include "axisym/spectral/lagrangian.h"

namespace sbeh::axisym::spectral {

/// A critical point.
struct Critical {
  Eigen::VectorXd y;
  Multipliers multipliers;
  double energy;
  double residual;  ///< largest of the misses of the measures and of ∂𝓛/∂(n-th mode)/(1 + n)
  double
      stiffness;  ///< smallest eigenvalue of the second variation at these measures, > 0 of a minimum
  int negative_directions;  ///< how many are negative
};

/// Minimises U at these measures, starting from y. Empty unless it ends in a minimum, to rounding
/// (residual < 1e-10).
std::optional<Critical> minimise(const Problem& problem, const Eigen::VectorXd& target,
                                 Eigen::VectorXd y);

/// The critical point next to y, be it a minimum or a saddle. Empty where Newton's method does not converge, or leads
/// further than `far` (largest change of an unknown).
std::optional<Critical> critical_point(const Problem& problem, const Eigen::VectorXd& target,
                                       Eigen::VectorXd y, double far = 0.5);

}  // namespace sbeh::axisym::spectral
