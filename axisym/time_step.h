// One time step of the ALE scheme: velocity, pressure, curvature and mesh motion, then the order.
#pragma once

#include "axisym/coupled_system.h"
#include "axisym/order_step.h"
#include "model/material.h"
#include "model/time/flow_record.h"

namespace sbeh::axisym {

using model::Dissipation;
using FlowStep = model::FlowStep<State>;

/// First-order semi-implicit step (coupled step, then the order with its velocity, so that a step
/// is a function of position and order alone; both together where lipids have another area when they are ordered). Keeps its matrices between steps.
class TimeStepper {
 public:
  TimeStepper(const model::Material& material, model::Model model, int elements);

  /// Advances by tau > 0, to the area and volume of the target; without one, keeping them. The curve must
  /// have the number of elements given to the constructor.
  FlowStep step(const State& old, const std::optional<Target>& target, double tau);
  /// Of the last solve.
  const StepFields& fields() const { return fields_; }

 private:
  State once(const State& old, const Field& H, const Field& lipids, std::optional<double> total,
             double tau);
  Field lipids_of(const State& old, const Field& beta, double tau) const;

  model::Material material_;
  model::Model model_;
  CoupledSystem coupled_;
  OrderStep order_;
  StepFields fields_{};
};

}  // namespace sbeh::axisym
