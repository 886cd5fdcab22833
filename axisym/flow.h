// An evolution in time: adaptive steps, exact output times, and the reason why it stopped.
#pragma once

#include "axisym/diagnostics.h"
#include "axisym/options.h"
#include "axisym/time_step.h"

#include <functional>
#include <string>
#include <vector>

namespace sbeh::axisym {

/// One accepted step as observers see it.
struct FlowRecord {
  double time = 0;       ///< at its end
  double time_step = 0;  ///< τ, 0 for the start
  Energy energy;
  Dissipation dissipation;    ///< mean rates over the step
  double energy_balance = 1;  ///< (U_old − U_new)/(τ · dissipation): 1 + O(τ)
  double normal_speed = 0;    ///< largest normal displacement per time
  double order_speed = 0;     ///< largest change of order per time
  double speed_max = 0;       ///< largest speed of the material, |V|
  double lambda = 0;          ///< volume multiplier
  int rejected = 0;           ///< steps rejected so far
};

/// Sees every accepted step; `exact` tells that the time is one of the output times. Returning false
/// interrupts the run.
using FlowObserver = std::function<bool(const FlowRecord&, const State&, bool exact)>;

/// Relative difference below which two output times are one.
inline constexpr double same_time = 1e-10;

struct FlowSchedule {
  double end_time = 1;
  std::vector<double>
      output_times;          ///< met exactly, in any order; those beyond the end are ignored,
                             ///< those that differ by less than same_time are met once
  bool stop_at_rest = true;  ///< at Numerics::rest_speed
};

enum class FlowStop { end_time, at_rest, unresolved, step_too_small, interrupted };
/// A sentence for tables and messages.
std::string describe(FlowStop stop);

struct FlowResult {
  FlowStop stop;
  State state;
  FlowRecord last;
  int steps;
};

/// |H| times the node spacing above which a rim counts as unresolved.
inline constexpr double resolution_limit = 0.35;

/// Runs the flow from `start`, keeping its own area and volume at `target` to rounding.
/// A step is rejected and halved when its error exceeds Numerics::tolerance, when a solve fails, or
/// when the energy rises and the step's error is not negligible; rejection leaves no trace but the count.
FlowResult run_flow(const model::Material& material, model::Model model, const State& start,
                    const Target& target, const Numerics& numerics, const FlowSchedule& schedule,
                    const FlowObserver& observe = {});

}  // namespace sbeh::axisym
