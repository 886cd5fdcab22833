#include "model/time/step_control.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace sbeh::model {

void TimeControl::validate() const {
  check_parameters(*this);
  if (smallest_step > largest_step || first_step > largest_step)
    throw std::invalid_argument(
        fmt::format("largest_step = {}: must be >= first_step and smallest_step", largest_step));
}

Stops::Stops(const FlowSchedule& schedule, double from) : times_(schedule.output_times) {
  times_.push_back(schedule.end_time);
  std::sort(times_.begin(), times_.end());
  const auto same = [](double a, double b) { return b - a <= same_time * std::abs(b); };
  times_.erase(std::unique(times_.begin(), times_.end(), same), times_.end());
  if (same(times_.back(), schedule.end_time)) times_.back() = schedule.end_time;
  begin_at_one_ = times_.front() <= from;
  while (next_ < times_.size() && times_[next_] <= from) ++next_;
}

namespace {

// A rise of the energy is the time step's fault when it is more than rounding and when the step's
// error is not negligible; otherwise it is the mesh's, whose motion moves the discrete energy.
constexpr double negligible_error = 1e-2;  // of the tolerance

}  // namespace

double wanted_growth(double tolerance, double error, int order) {
  return 0.9 * (order == 3 ? std::cbrt(tolerance / error) : std::sqrt(tolerance / error));
}

StepControl::StepControl(const TimeControl& control, double largest_growth, double tau)
    : control_(control),
      largest_growth_(largest_growth),
      tau_(tau > 0 ? tau : control.first_step) {}

Trial StepControl::trial(double remaining) const {
  if (tau_ >= remaining * (1 - 1e-9)) return {remaining, true};
  return {std::min(tau_, remaining / 2), false};
}

FlowFault StepControl::judge(double error, const Energy& before, const Energy& after) const {
  if (!(error <= control_.tolerance)) return FlowFault::error;
  const bool rises = !(after.total() <= before.total() + energy_noise(before));
  return rises && error > negligible_error * control_.tolerance ? FlowFault::energy_rises
                                                                : FlowFault::none;
}

bool StepControl::reject(const Trial& trial, FlowFault fault, double error, int error_order) {
  const double factor = fault == FlowFault::error ? std::clamp(
                            wanted_growth(control_.tolerance, error, error_order), 0.1, 0.5)
                                                  : 0.1;
  tau_ = trial.tau * factor;
  rejected_ = true;
  return tau_ >= control_.smallest_step;
}

void StepControl::accept(const Trial& trial, double error, int error_order) {
  const double most = std::exchange(rejected_, false) ? 1. : 2.;
  const double factor =
      std::clamp(wanted_growth(control_.tolerance, error, error_order), 0.3, most);
  // A step cut short by a stop says little about the next one.
  const double wanted = std::max(trial.exact ? tau_ : 0, trial.tau * factor);
  tau_ = std::min({control_.largest_step, trial.tau * largest_growth_, wanted});
}

void StepControl::restart() { tau_ = std::min(tau_, control_.first_step); }

}  // namespace sbeh::model
