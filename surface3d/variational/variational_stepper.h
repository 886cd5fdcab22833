// One time step by Onsager's principle: velocity, pressure, multipliers, order and the next surface solved together by
// Newton's method.
#pragma once

#include "model/time/flow_record.h"
#include "surface3d/lagged_solver.h"
#include "surface3d/linear/direct_solver.h"
#include "surface3d/split.h"
#include "surface3d/time_step.h"
#include "surface3d/variational/step_functional.h"

#include <memory>
#include <optional>

namespace sbeh::surface3d {

/// First order in τ, and the energy falls in a step of any length: where the stationary point that Newton's method finds is no minimum
/// of what is to be minimal, or is not found, the step has a fault and a shorter one may be tried. The mesh moves along the normals by
/// the flow, and along itself as in split.h. Area and volume are met exactly. Not for spheres, which cannot move.
class VariationalStepper {
 public:
  VariationalStepper(const std::shared_ptr<const Triangulation>& mesh,
                     const model::Material& material, model::Model model, const Numerics&);

  /// Advances by tau > 0, to the area and volume of the target; without one, keeping them.
  FlowStep step(const State& old, const std::optional<Target>& target, double tau);
  /// U, as its steps have it: see stationary/lagrangian.h.
  Energy energy(const State& state, const Curvature& curvature) const {
    return surface3d::energy(material_, *mesh_, StationaryState{state, curvature.H});
  }
  /// Of the last step; empty before.
  const StepFields& fields() const { return fields_; }

  // Its steps have no past.
  StepperMemory memory() const { return {}; }
  [[nodiscard]] bool recall(const StepperMemory&) const { return true; }

 private:
  struct Unknowns;
  std::optional<Nodes> motion_along(const State& old, const Curvature& curvature, double tau);
  model::FlowFault solve(const StepBase& base, const Target& target, Unknowns& x);
  bool linearise(const StepBase& base, const Unknowns& x);
  FlowStep result_of(const StepBase& base, const Unknowns& x);

  std::shared_ptr<const Triangulation> mesh_;
  model::Material material_;
  model::Model model_;
  StepLayout layout_;
  Split along_;
  StepResistance resistance_{};
  LagrangianDerivatives energy_{};
  SparseMatrix matrix_, bordered_;
  DirectSolver solver_{Symmetry::symmetric}, motion_solver_{Symmetry::symmetric};
  StepFields fields_{};
};

}  // namespace sbeh::surface3d
