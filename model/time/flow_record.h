// One step in time as an integrator gives it, what may be wrong with it, and what a run says of itself: one
// record for each accepted step, and the result.
#pragma once

#include "model/energy.h"

#include <algorithm>
#include <functional>
#include <optional>
#include <string>

namespace sbeh::model {

/// Why a step was not accepted.
enum class FlowFault {
  none,
  linear_solve,  ///< a system was singular, or its iteration did not converge
  degenerate,    ///< a triangle is turned over, or the curve or surface is not finite
  area_volume,   ///< area and volume could not be restored
  error,         ///< above the tolerance
  energy_rises
};
/// What was wrong and what may help, in one sentence; empty without a fault.
std::string describe(FlowFault fault);

/// The rest holds only when there is no fault.
template <class State>
struct FlowStep {
  FlowFault fault = FlowFault::linear_solve;
  State state = {};
  Dissipation dissipation = {};
  double lambda = 0, speed_max = 0;
  double order_speed = 0;  ///< root mean square of β̇, the rate of the material
  double error = 0;     ///< of a step of an order lower: largest normal distance or change of order
  int error_order = 2;  ///< in τ
  bool ok() const { return fault == FlowFault::none; }
};

/// Largest normal distance and change of order between two states.
struct Distance {
  double normal, order;
  double largest() const { return std::max(normal, order); }
};

// In files by their places: new ones come last.
enum class FlowStop {
  end_time,
  at_rest,
  unresolved,
  self_contact,
  step_too_small,
  interrupted,
  near_rest  ///< from where Newton's method leads to rest
};
/// Words for tables and messages.
std::string describe(FlowStop stop);

/// What steps have added to the energy, which ought to fall: more than rounding, and not by a new mesh.
struct EnergyRises {
  double sum = 0;
  double from = 0, to = 0;  ///< times, of the first and of the last
};

/// One accepted step as observers see it.
struct FlowRecord {
  double time = 0;       ///< at its end
  double time_step = 0;  ///< τ, 0 for the start
  Energy energy;
  Dissipation dissipation;            ///< mean rates over the step
  double energy_balance = 1;          ///< (U_old − U_new)/(τ · dissipation): 1 + O(τ)
  double normal_speed = 0;            ///< largest normal displacement per time
  double order_speed = 0;             ///< root mean square of β̇, the rate of the material
  double speed_max = 0;               ///< largest speed of the material, |V|
  double lambda = 0;                  ///< volume multiplier
  double next_step = 0;               ///< τ of the next try; 0 before a run has begun
  int rejected = 0;                   ///< steps rejected so far
  EnergyRises rises = {};             ///< so far
  std::optional<FlowStop> ends = {};  ///< why the run ends with this step, if it does

  /// What is small at rest.
  double speed() const { return std::max(normal_speed, order_speed); }
};

/// Whether the rises exceed in sum 1e-5 of the elastic energy, to which 320 triangles give that of a shape.
bool rises_too_far(const FlowRecord& last);

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
