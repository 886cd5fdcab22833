#include "studies/evolution/flow_progress.h"

#include <fmt/format.h>

#include <algorithm>

namespace sbeh::studies {

namespace {

constexpr double terminal_pace = 0.2, log_pace = 60;  // seconds

std::string progress_text(const model::FlowRecord& record, double end_time) {
  return fmt::format("t = {:.4g} of {:.4g}, time step {:.2g}, energy {:.8g}", record.time, end_time,
                     record.time_step, record.energy.total());
}

}  // namespace

void BriefProgress::see(const model::FlowRecord& record) {
  if (line_.on_terminal() && line_.age() > terminal_pace)
    line_.show(name_ + progress_text(record, end_time_));
}

void LongProgress::see(const model::FlowRecord& record) {
  ++steps_;
  const double seconds = watch_.seconds();
  const double pace = line_.on_terminal() ? terminal_pace : log_pace;
  if (std::min(line_.age(), seconds) < pace) return;
  const double per_step = seconds / steps_;
  const double left = (end_time_ - record.time) / record.next_step * per_step;
  line_.show(fmt::format("{}, {:.2g} s a step, at most {:.0f} s left",
                         progress_text(record, end_time_), per_step, left));
}

}  // namespace sbeh::studies
