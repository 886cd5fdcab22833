// One time step by Onsager's principle: velocity, pressure, multipliers, order and the next surface solved together by
// Newton's method.
#pragma once

#include "model/time/flow_record.h"
#include "surface3d/lagged_solver.h"
#include "surface3d/split.h"
#include "surface3d/time_step.h"
#include "surface3d/variational/step_matrix.h"

#include <memory>
#include <optional>

namespace sbeh::surface3d {

/// First order in τ, and the energy falls in a step of any length: where the stationary point that Newton's method finds is no minimum
/// of what is to be minimal, or is not found, the step has a fault and a shorter one may be tried. The mesh moves along the normals by
/// the flow, and along itself as in split.h. Area and volume are met exactly. Not for spheres, which cannot move. Of the numerics
/// factorisation and tolerance count: Newton's method begins with what the last steps lead to, with the matrix of an earlier step as
/// long as changes fall fast, and ends where what is left is a thousandth of the step and of the tolerance.
class VariationalStepper {
 public:
  VariationalStepper(const std::shared_ptr<const Triangulation>& mesh,
                     const model::Material& material, model::Model model, const Numerics& numerics);

  /// Advances by tau > 0, to the area and volume of the target; without one, keeping them.
  FlowStep step(const State& old, const std::optional<Target>& target, double tau);
  /// U, as its steps have it: see stationary/lagrangian.h.
  Energy energy(const State& state, const Curvature& curvature) const {
    return surface3d::energy(material_, *mesh_, StationaryState{state, curvature.H});
  }
  /// Of the last step; empty before.
  const StepFields& fields() const { return fields_; }

  /// `flow` of its solutions: velocities, β̇, Λ, H, p and the other multipliers.
  const StepperMemory& memory() const { return memory_; }
  /// Factors anew what another stepper had factored. False where that is singular.
  [[nodiscard]] bool recall(const StepperMemory& memory);

 private:
  struct Unknowns;
  std::optional<Nodes> motion_along(const State& old, const Curvature& curvature, double tau);
  bool has_past() const { return memory_.last.flow.size() > 0; }
  Unknowns guess(const StepBase& base) const;
  Nodes motion_of(const StepBase& base, const Unknowns& x) const;  // of the material
  void remember(const StepBase& base, const Unknowns& x);
  bool worth_factoring(double tau) const;
  bool factor(const State& at, const Curvature& curvature, double tau);
  bool factor_here(const StepBase& base, const Unknowns& x);
  int correct(const StepBase& base, const Target& target, Unknowns& x, double& change);
  model::FlowFault solve(const StepBase& base, const Target& target, Unknowns& x,
                         bool always_factors);
  bool is_minimum(const StepBase& base, const Unknowns& x);
  double value_at_rest(const StepBase& base, const Field& H, const Target& target,
                       const Unknowns& x);
  double value_of(const StationaryState& state, const Target& target) const;
  int multipliers() const { return multiplier_count(material_); }  // of U
  Eigen::Index past_size() const;
  double enough(const StepBase& base, const Unknowns& x) const;
  FlowStep result_of(const StepBase& base, const Unknowns& x);

  std::shared_ptr<const Triangulation> mesh_;
  model::Material material_;
  model::Model model_;
  bool always_factors_;
  double tolerance_;
  StepLayout layout_;
  Split along_;
  StepResistance resistance_{}, factored_{};
  LagrangianGradient energy_{};
  double value_ =
      0;  // of what is to be stationary, but for a constant, where Newton's method was last
  StepMatrix matrix_;
  DirectSolver motion_solver_{Symmetry::symmetric};
  StepperMemory memory_{};
  StepFields fields_{};
};

}  // namespace sbeh::surface3d
