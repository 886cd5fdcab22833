// The steps of a run: which are accepted, and which τ comes next.
#pragma once

#include "model/energy.h"
#include "model/time/flow_step.h"
#include "model/time/time_control.h"

namespace sbeh::model {

/// A step to be tried.
struct Trial {
  double tau;
  bool exact;  ///< ends exactly at the next stop
};

class StepControl {
 public:
  /// `tau` of the first try; 0: that of a run that begins. `largest_growth` from one step to the next.
  StepControl(const TimeControl& control, double largest_growth, double tau);

  /// τ of the next try where no stop is near.
  double tau() const { return tau_; }
  /// The next try, `remaining` before a stop: never so that a tiny rest is left.
  Trial trial(double remaining) const;

  /// What is wrong with a step that could be made: its error exceeds the tolerance, or the energy rises
  /// and the step's error is not negligible.
  FlowFault judge(double error, const Energy& before, const Energy& after) const;
  /// The next try is shorter; false when it would be too short.
  [[nodiscard]] bool reject(const Trial& trial, FlowFault fault, double error);
  void accept(const Trial& trial, double error);
  /// A new mesh has to settle.
  void restart();

 private:
  TimeControl control_;
  double largest_growth_;
  double tau_;
};

}  // namespace sbeh::model
