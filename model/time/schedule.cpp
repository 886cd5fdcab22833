#include "model/time/schedule.h"

#include <algorithm>
#include <cmath>

namespace sbeh::model {

Stops::Stops(const FlowSchedule& schedule, double from) : times_(schedule.output_times) {
  times_.push_back(schedule.end_time);
  std::sort(times_.begin(), times_.end());
  const auto same = [](double a, double b) { return b - a <= same_time * std::abs(b); };
  times_.erase(std::unique(times_.begin(), times_.end(), same), times_.end());
  if (same(times_.back(), schedule.end_time)) times_.back() = schedule.end_time;
  begin_at_one_ = times_.front() <= from;
  while (next_ < times_.size() && times_[next_] <= from) ++next_;
}

}  // namespace sbeh::model
