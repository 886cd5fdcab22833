// What a user may choose of the time steps of a run.
#pragma once

#include "model/parameter.h"

namespace sbeh::model {

/// How a run chooses its time steps; see the table below.
struct TimeControl {
  double tolerance = 1e-5;
  double first_step = 1e-6;
  double smallest_step = 1e-12;
  double largest_step = 0.05;  // the coupling of shape and order oscillates from about 0.1 on
  bool extrapolate = true;
  double rest_speed = 1e-6;

  /// Throws std::invalid_argument with name, value and constraint.
  void validate() const;

  bool operator==(const TimeControl&) const = default;
};

/// The table of its parameters.
template <maybe_const<TimeControl> T>
void for_each_parameter(T& control, auto&& visit) {
  using P = Parameter;
  visit(P{"tolerance", between(1e-12, 0.1), "error allowed in one step, of positions and order"},
        control.tolerance);
  visit(P{"first_step", between(1e-14, 10), "τ of the first try, also on a new mesh"},
        control.first_step);
  visit(P{"smallest_step", between(1e-16, 1), "τ below which the run stops: time step too small"},
        control.smallest_step);
  visit(P{"largest_step", between(1e-14, 1e3), "τ never exceeds it"}, control.largest_step);
  visit(P{"extrapolate",
          {},
          "a step and two half steps combined to second order in τ; false: the two half steps, "
          "first order"},
        control.extrapolate);
  visit(P{"rest_speed", between(1e-14, 1), "a run is stationary when no point is faster than this"},
        control.rest_speed);
}

}  // namespace sbeh::model
