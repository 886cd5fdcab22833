// What a user may choose of the numerics: the mesh of the generating curve and the time steps.
#pragma once

#include "model/time/flow.h"

namespace sbeh::axisym {

/// How the axisymmetric solvers discretise. Defaults hold the stationary energies of the paper's
/// scan to 1e-7 relative under halving of both the elements and the steps.
struct Numerics : model::TimeControl {
  int elements = 48;     ///< P3 elements from pole to pole, 8 … 4096
  double grading = 0.5;  ///< how strongly elements gather where curvature is large, 0 … 4

  /// Throws std::invalid_argument with name, value and constraint.
  void validate() const;
};

}  // namespace sbeh::axisym
