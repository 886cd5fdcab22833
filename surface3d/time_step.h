// One time step of the ALE scheme: velocity, pressure, curvature and mesh motion, then the order.
#pragma once

#include "model/material.h"
#include "model/time/flow_record.h"
#include "surface3d/coupled_system.h"
#include "surface3d/diagnostics.h"
#include "surface3d/dissipation.h"
#include "surface3d/lagged_solver.h"

#include <memory>
#include <optional>

namespace sbeh::surface3d {

using FlowStep = model::FlowStep<State>;
struct OrderStepResult;

/// What a step computes besides the next state.
struct StepFields {
  Nodes V;        // 3 x nodes, velocity on the old surface
  Nodes Y;        // 3 x nodes, displacement of the mesh, from where the step begins
  Field H;        // nodes, curvature of the next surface as the scheme knows it
  Field p;        // P2 nodes, surface pressure; with lipid_density over n/n(2/3)
  double lambda;  ///< volume multiplier
};

/// First-order semi-implicit step (coupled step, then the order with its velocity, so that a step
/// is a function of position and order alone; both together where lipids have another area when they are ordered). Keeps its matrices between steps. Of the numerics scheme,
/// factorisation and solver_tolerance count. Where κ is below a tenth of its
/// largest value the step is solved up to three times more, each time at the state that it led to, until that
/// changes by no more than 2 solver_tolerance: a sharp rim would waver otherwise.
class TimeStepper {
 public:
  TimeStepper(const std::shared_ptr<const Triangulation>& mesh, const model::Material& material,
              model::Model model, const Numerics& numerics = {});

  /// Advances by tau > 0, to the area and volume of the target; without one, keeping them.
  FlowStep step(const State& old, const std::optional<Target>& target, double tau) {
    return step(old, old, target, tau);
  }
  /// Advances from `from` with the surface and the coefficients of `at`, keeping its area and volume: of a
  /// two-step method.
  FlowStep step(const State& at, const State& from, double tau) { return step(at, from, {}, tau); }
  /// What falls from step to step: U with det B for the Gaussian curvature, of one constant (κ/2)|B|², which takes in what is uneven in
  /// the surface.
  Energy own_energy(const State& state, const Curvature& curvature) const {
    return energy_by_shape_operator(*mesh_, material_, state, curvature);
  }
  /// U
  Energy energy(const State& state, const Curvature& curvature) const {
    return surface3d::energy(*mesh_, material_, state, curvature);
  }
  /// Of the last solve; empty before.
  const StepFields& fields() const { return fields_; }

  const StepperMemory& memory() const { return solver_.memory(); }
  /// Factors anew what another stepper had factored. False where that is singular.
  [[nodiscard]] bool recall(const StepperMemory& memory);

 private:
  FlowStep step(const State& at, const State& from, const std::optional<Target>& target,
                double tau);
  StepFields fields_of(const Solution& x) const;
  FlowStep solve(const State& at, const State& from, const Constraints& constraints, double tau,
                 Pass pass);
  OrderStepResult order_after(const State& at, const State& from, const Curvature& curvature,
                              double tau) const;
  FlowStep result_of(const State& at, const State& from, const OrderStepResult& order,
                     const Motion& motion) const;

  std::shared_ptr<const Triangulation> mesh_;
  model::Material material_;
  model::Model model_;
  CoupledSystem system_;
  LaggedSolver solver_;
  StepFields fields_{};
  std::optional<double> total_order_;  // ∫β dS after the step, where it is conserved
};

}  // namespace sbeh::surface3d
