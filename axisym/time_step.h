// One time step of the ALE scheme: velocity, pressure, curvature and mesh motion, then the order.
#pragma once

#include "axisym/coupled_system.h"
#include "model/energy.h"
#include "model/material.h"

namespace sbeh::axisym {

using model::Dissipation;

/// Result of a step; `ok` is false when a linear solve failed or the new curve is degenerate, and
/// then nothing else holds.
struct StepResult {
  bool ok = false;
  State state;
  StepFields fields;
  Dissipation dissipation;
};

/// First-order semi-implicit step (coupled step, then the order with its velocity, so that a step
/// is a function of position and order alone). Keeps its matrices between steps.
class TimeStepper {
 public:
  TimeStepper(const model::Material& material, model::Model model, int elements);

  /// Advances by tau > 0. The curve must have the number of elements given to the constructor.
  StepResult step(const State& old, const Target& target, double tau);

 private:
  // False when the matrix is singular.
  bool solve_order(const State& old, const Field& H, const StepFields& fields, double tau,
                   Field& beta);

  model::Material material_;
  model::Model model_;
  CoupledSystem coupled_;
  model::BandMatrix order_;
};

}  // namespace sbeh::axisym
