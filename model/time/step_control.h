// The steps of a run: what a user may choose of them, the times that they meet exactly, which of them are
// accepted, and which τ comes next.
#pragma once

#include "model/parameter.h"
#include "model/time/flow_record.h"

#include <cstddef>
#include <vector>

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
  visit(P{"rest_speed", between(1e-14, 1),
          "no point is faster at rest, of the default material; of others in proportion, see "
          "model/equations.md"},
        control.rest_speed);
}

/// When a run ends, and the times that it meets exactly.
struct FlowSchedule {
  double end_time = 1;
  std::vector<double> output_times = {};  ///< in any order; those beyond the end are ignored, those
                                          ///< that differ by less than same_time are met once
  bool stop_at_rest = true;               ///< at TimeControl::rest_speed
};

/// Relative difference below which two times are one.
inline constexpr double same_time = 1e-10;

/// The output times and the end, as a run that begins at a time comes to them.
class Stops {
 public:
  Stops(const FlowSchedule& schedule, double from);

  /// Whether the run begins at one.
  bool begin_at_one() const { return begin_at_one_; }
  /// The next one; not to be asked for beyond the end.
  double next() const { return times_[next_]; }
  void pass() { ++next_; }

 private:
  std::vector<double> times_;  // ascending
  std::size_t next_ = 0;
  bool begin_at_one_;
};

/// Changes of the energy below it are rounding.
inline double energy_noise(const Energy& energy) { return 1e-10 * energy.magnitude(); }

/// The factor by which τ may change so that an error of this order in τ is the tolerance, with a little room.
double wanted_growth(double tolerance, double error, int order);

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
  [[nodiscard]] bool reject(const Trial& trial, FlowFault fault, double error, int error_order);
  void accept(const Trial& trial, double error, int error_order);
  /// A new mesh has to settle.
  void restart();

 private:
  TimeControl control_;
  double largest_growth_;
  double tau_;
  bool rejected_ = false;  // since the last accepted step: the next one is no longer than this
};

}  // namespace sbeh::model
