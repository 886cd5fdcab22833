// One time step of the ALE scheme: velocity, pressure, curvature and mesh motion, then the order.
#pragma once

#include "model/material.h"
#include "model/time/flow_record.h"
#include "surface3d/coupled_system.h"
#include "surface3d/lagged_solver.h"

#include <memory>

namespace sbeh::surface3d {

using model::Dissipation;

/// What a step computes besides the next state.
struct StepFields {
  Nodes V;        // 3 x nodes, velocity on the old surface
  Nodes Y;        // 3 x nodes, displacement of the mesh, from where the step begins
  Field H;        // nodes, curvature of the next surface as the scheme knows it
  Field p;        // P2 nodes, surface pressure
  double lambda;  ///< volume multiplier
};

/// Result of a step; the rest holds only when there is no fault.
struct StepResult {
  model::FlowFault fault = model::FlowFault::linear_solve;
  bool ok() const { return fault == model::FlowFault::none; }
  State state;
  StepFields fields;
  Dissipation dissipation;
};

/// First-order semi-implicit step (coupled step, then the order with its velocity, so that a step
/// is a function of position and order alone). Keeps its matrices between steps. The scheme is the
/// stable_scheme. The linear systems are solved to `solver_tolerance`, see LaggedSolver. Where κ is below a
/// tenth of its largest value the step is solved up to three times more, each time at the state that it led
/// to, until that changes by no more than 2 solver_tolerance: a sharp rim would waver otherwise.
class TimeStepper {
 public:
  TimeStepper(const std::shared_ptr<const Triangulation>& mesh, const model::Material& material,
              model::Model model, Scheme scheme = Scheme::split,
              Factorisation factorisation = Factorisation::lagged,
              double solver_tolerance = default_solver_tolerance);

  /// Advances by tau > 0.
  StepResult step(const State& old, const Target& target, double tau) {
    return step(old, old, target, tau);
  }
  /// Advances from `from` with the surface and the coefficients of `at`: of a two-step method. `target`
  /// counts from the area and volume of `at`.
  StepResult step(const State& at, const State& from, const Target& target, double tau);

  const StepperMemory& memory() const { return solver_.memory(); }
  /// Factors anew what another stepper had factored. False where that is singular.
  [[nodiscard]] bool recall(const StepperMemory& memory);

 private:
  StepFields fields_of(const Solution& x) const;
  StepResult solve(const State& at, const State& from, const Constraints& constraints, double tau,
                   Pass pass);

  std::shared_ptr<const Triangulation> mesh_;
  model::Material material_;
  model::Model model_;
  CoupledSystem system_;
  LaggedSolver solver_;
};

}  // namespace sbeh::surface3d
