// One step in time as an integrator gives it, and what may be wrong with it.
#pragma once

#include "model/energy.h"

#include <algorithm>
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
  double error = 0;  ///< of a first-order step: largest normal distance or change of order
  bool ok() const { return fault == FlowFault::none; }
};

/// Largest normal distance and change of order between two states.
struct Distance {
  double normal, order;
  double largest() const { return std::max(normal, order); }
};

}  // namespace sbeh::model
