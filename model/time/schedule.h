// When a run ends, and the times that it meets exactly.
#pragma once

#include <cstddef>
#include <vector>

namespace sbeh::model {

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

}  // namespace sbeh::model
