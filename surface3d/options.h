// What a user may choose of the numerics of the 3D solver.
#pragma once

#include "model/time/flow.h"
#include "surface3d/time_step.h"

namespace sbeh::surface3d {

enum class Integrator {
  two_step,      ///< second order for one solve a step, see model/time/two_step.h
  step_doubling  ///< three solves a step, see model/time/step_doubling.h
};
/// "two-step" or "step-doubling".
const char* name(Integrator integrator);

/// How the 3D solver steps in time. The mesh is chosen with the start.
struct Numerics : model::TimeControl {
  Numerics() {
    tolerance = 1e-4;
    first_step = 1e-5;
  }
  Integrator integrator = Integrator::two_step;
  Scheme scheme = Scheme::split;
  Factorisation factorisation = Factorisation::lagged;
  double solver_tolerance = default_solver_tolerance;  ///< of the linear systems, 1e-12 … 1e-2
  bool remesh = false;        ///< make new triangles where they do not resolve the surface
  int most_triangles = 5120;  ///< not more than so many, 20 … 200000

  /// Throws std::invalid_argument with name, value and constraint.
  void validate() const;
};

}  // namespace sbeh::surface3d
