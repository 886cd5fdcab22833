// What a run says of itself: one record for each accepted step, and the result.
#pragma once

#include "model/energy.h"
#include "model/time/flow_step.h"

#include <functional>
#include <optional>
#include <string>

namespace sbeh::model {

enum class FlowStop { end_time, at_rest, unresolved, self_contact, step_too_small, interrupted };
/// Words for tables and messages.
std::string describe(FlowStop stop);

/// One accepted step as observers see it.
struct FlowRecord {
  double time = 0;       ///< at its end
  double time_step = 0;  ///< τ, 0 for the start
  Energy energy;
  Dissipation dissipation;            ///< mean rates over the step
  double energy_balance = 1;          ///< (U_old − U_new)/(τ · dissipation): 1 + O(τ)
  double normal_speed = 0;            ///< largest normal displacement per time
  double order_speed = 0;             ///< largest change of order per time
  double speed_max = 0;               ///< largest speed of the material, |V|
  double lambda = 0;                  ///< volume multiplier
  double next_step = 0;               ///< τ of the next try; 0 before a run has begun
  int rejected = 0;                   ///< steps rejected so far
  std::optional<FlowStop> ends = {};  ///< why the run ends with this step, if it does
};

/// Sees every accepted step; `exact` tells that the time is one of the output times. Returning false
/// interrupts the run.
template <class State>
using FlowObserver = std::function<bool(const FlowRecord&, const State&, bool exact)>;

template <class State>
struct FlowResult {
  FlowStop stop;
  State state;
  FlowRecord last;
  int steps;
  FlowFault fault = FlowFault::none;  ///< of the last step that was rejected
};

}  // namespace sbeh::model
