// What a user may choose of the numerics of the 3D solver.
#pragma once

#include "model/flow.h"
#include "surface3d/time_step.h"

namespace sbeh::surface3d {

/// How the 3D solver steps in time. The mesh is chosen with the start.
struct Numerics : model::TimeControl {
  Numerics() {
    tolerance = 1e-4;
    first_step = 1e-5;
  }
  Scheme scheme = Scheme::split;
  Factorisation factorisation = Factorisation::lagged;

  /// Throws std::invalid_argument with name, value and constraint.
  using TimeControl::validate;
};

}  // namespace sbeh::surface3d
