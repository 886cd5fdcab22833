// One time step of the ALE scheme: velocity, pressure, curvature and mesh motion, then the order.
#pragma once

#include "model/material.h"
#include "model/time/flow_step.h"
#include "surface3d/coupled_system.h"
#include "surface3d/surface.h"

#include <array>
#include <memory>

namespace sbeh::surface3d {

using model::Dissipation;
using model::Target;

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

/// How a step solves its linear systems.
enum class Factorisation {
  lagged,     ///< factors of an earlier step, refactored when that is cheaper
  every_step  ///< the reference: exact solutions
};
constexpr auto values_of(Factorisation) {
  return std::array{Factorisation::lagged, Factorisation::every_step};
}
/// "lagged" or "every-step".
const char* name(Factorisation factorisation);

inline constexpr double default_solver_tolerance = 1e-5;

/// Solutions of the linear systems of a step, in their numbering; displacements by τ.
struct Solution {
  Eigen::VectorXd flow, motion;  ///< empty before the first step
  double tau = 0;
};

/// What a stepper remembers of the past besides its last state: where its factors come from, and what
/// its iterations begin with. With it a resumed run repeats the bits of one that was not interrupted.
struct StepperMemory {
  State factored_at;  ///< empty when there are no factors
  double factored_tau = 0;
  int solves = 0;      ///< since then
  int iterations = 0;  ///< in all of them
  int last_iterations = 0;
  Solution last, before;
};

/// What solving has cost so far.
struct SolverCounts {
  int steps = 0, factorisations = 0, iterations = 0;
};

/// First-order semi-implicit step (coupled step, then the order with its velocity, so that a step
/// is a function of position and order alone). Keeps its matrices between steps. A flow that keeps area
/// locally and has no viscosity is always solved by the monolithic scheme. The linear systems are solved
/// to `solver_tolerance`, see LaggedSolver. Where κ is below a tenth of its largest value the step is
/// solved up to three times more, each time at the state that it led to, until that changes by no more
/// than 2 solver_tolerance: a sharp rim would waver otherwise.
class TimeStepper {
 public:
  TimeStepper(const std::shared_ptr<const Triangulation>& mesh, const model::Material& material,
              model::Model model, Scheme scheme = Scheme::split,
              Factorisation factorisation = Factorisation::lagged,
              double solver_tolerance = default_solver_tolerance);
  ~TimeStepper();
  TimeStepper(TimeStepper&&) noexcept;
  TimeStepper& operator=(TimeStepper&&) noexcept;

  /// Advances by tau > 0.
  StepResult step(const State& old, const Target& target, double tau) {
    return step(old, old, target, tau);
  }
  /// Advances from `from` with the surface and the coefficients of `at`: of a two-step method. `target`
  /// counts from the area and volume of `at`.
  StepResult step(const State& at, const State& from, const Target& target, double tau);

  const StepperMemory& memory() const;
  /// Factors anew what another stepper had factored. False where that is singular.
  [[nodiscard]] bool recall(const StepperMemory& memory);
  SolverCounts counts() const;

 private:
  struct Workspace;
  std::unique_ptr<Workspace> work_;
};

}  // namespace sbeh::surface3d
