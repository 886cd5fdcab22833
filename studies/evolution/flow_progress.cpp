#include "studies/evolution/flow_progress.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>

namespace sbeh::studies {

namespace {

constexpr double terminal_pace = 0.2, log_pace = 60;  // seconds
constexpr std::size_t known_steps = 20;               // that tell a rate
constexpr double most_change = 2;  // of the time gone, from one half of them to the other

std::string progress_text(const model::FlowRecord& record, double end_time) {
  return fmt::format("t = {:.4g} of {:.4g}, time step {:.2g}, energy {:.8g}", record.time, end_time,
                     record.time_step, record.energy.total());
}

}  // namespace

void TimeLeft::see(double time, double seconds) {
  latest_.push_back({time, seconds});
  if (latest_.size() > known_steps + 1) latest_.pop_front();
}

std::optional<double> TimeLeft::until(double end) const {
  if (latest_.size() <= known_steps) return {};
  const Moment& first = latest_.front();
  const Moment& middle = latest_[known_steps / 2];
  const Moment& last = latest_.back();
  const double before = middle.time - first.time, after = last.time - middle.time;
  if (!(before > 0) || after > most_change * before || before > most_change * after) return {};
  const double rate = (last.time - first.time) / (last.seconds - first.seconds);
  return std::max(0., end - last.time) / rate;
}

void BriefProgress::see(const model::FlowRecord& record) {
  if (line_.on_terminal() && line_.age() > terminal_pace)
    line_.show(name_ + progress_text(record, end_time_));
}

void LongProgress::see(const model::FlowRecord& record) {
  ++steps_;
  const double seconds = watch_.seconds();
  left_.see(record.time, seconds);
  const double pace = line_.on_terminal() ? terminal_pace : log_pace;
  if (std::min(line_.age(), seconds) < pace) return;
  const auto left = left_.until(end_time_);
  line_.show(fmt::format("{}, {:.2g} s a step{}", progress_text(record, end_time_),
                         seconds / steps_,
                         left ? fmt::format(", about {:.0f} s left", *left) : ""));
}

}  // namespace sbeh::studies
