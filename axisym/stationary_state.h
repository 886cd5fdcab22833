// A state at rest with what holds it there.
#pragma once

#include "axisym/curve.h"

namespace sbeh::axisym {

/// A critical point of the Lagrangian of stationary/stationary.h (or a guess of one).
struct StationaryState {
  State state;
  Field H;       // nodes, mean curvature
  Field Lambda;  // nodes, multiplier of the curvature equation, about −(κ(H − H₀) + κ_G B_φφ)
  double tension;   ///< Σ = −∂U/∂A
  double pressure;  ///< P = ∂U/∂V
};

}  // namespace sbeh::axisym
