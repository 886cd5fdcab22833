#include "studies/evolution/times.h"

#include <algorithm>

namespace sbeh::studies {

namespace {

std::vector<double> default_times(double first, double end, int count) {
  std::vector<double> times =
      evenly_spaced(std::min(first, end / 100), end, count, Spacing::logarithmic);
  times.insert(times.begin(), 0);
  return times;
}

}  // namespace

std::vector<double> default_row_times(double end) { return default_times(1e-5, end, 200); }
std::vector<double> default_state_times(double end) { return default_times(1e-3, end, 7); }

Times read_times(const TomlTable& time, std::string_view states) {
  Times times;
  times.end = time.number("end", above(0));
  const Interval run = between(0, times.end);
  times.rows = time.grid("output", run, default_row_times(times.end));
  times.states = time.grid(states, run, default_state_times(times.end));
  times.every_step = time.boolean("every_step", times.every_step);
  times.stop_at_rest = time.boolean("stop_at_rest", times.stop_at_rest);
  return times;
}

void write_times(TomlText& toml, const Times& times, std::string_view states) {
  toml.table("time");
  toml.value("end", times.end);
  toml.value("output", times.rows);
  toml.value(states, times.states);
  toml.value("every_step", times.every_step);
  toml.value("stop_at_rest", times.stop_at_rest);
}

model::FlowSchedule schedule_of(const Times& times) {
  model::FlowSchedule schedule{
      .end_time = times.end, .output_times = times.rows, .stop_at_rest = times.stop_at_rest};
  schedule.output_times.insert(schedule.output_times.end(), times.states.begin(),
                               times.states.end());
  return schedule;
}

bool contains(const std::vector<double>& times, double time) {
  const double slack = model::same_time * time;
  const auto at = std::lower_bound(times.begin(), times.end(), time - slack);
  return at != times.end() && *at <= time + slack;
}

}  // namespace sbeh::studies
