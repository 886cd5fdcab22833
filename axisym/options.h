// What a user may choose of the numerics: the mesh of the generating curve and the time steps.
#pragma once

namespace sbeh::axisym {

/// How the axisymmetric solvers discretise. Defaults hold the stationary energies of the paper's
/// scan to 1e-7 relative under halving of both the elements and the steps.
struct Numerics {
  int elements = 48;         ///< P3 elements from pole to pole, 8 … 4096
  double grading = 0.5;      ///< how strongly elements gather where curvature is large, 0 … 4
  double tolerance = 1e-5;   ///< error allowed in one time step, positions and order, 1e-12 … 0.1
  double first_step = 1e-6;  ///< τ of the first try, > 0
  double smallest_step = 1e-12;  ///< below it the run stops: "time step too small", > 0
  double largest_step =
      0.05;                  ///< τ never exceeds it, > 0; the explicit coupling of shape and order
                             ///< oscillates from about 0.1 on
  bool extrapolate = true;   ///< a step and two half steps combined to second order in τ;
                             ///< false: the two half steps, first order
  double rest_speed = 1e-6;  ///< a run is stationary when no point is faster than this, > 0

  /// Throws std::invalid_argument with name, value and constraint.
  void validate() const;
};

}  // namespace sbeh::axisym
