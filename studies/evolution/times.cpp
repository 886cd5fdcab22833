#include "studies/evolution/times.h"

#include <algorithm>
#include <cmath>

namespace sbeh::studies {

std::vector<double> default_row_times(double end) {
  constexpr int in_a_decade = 32;
  std::vector<double> times{0};
  const auto time = [](int k) { return std::pow(10., double(k) / in_a_decade); };
  const double first = std::min(1e-5, end / 100) * (1 - model::same_time);
  for (int k = int(std::ceil(in_a_decade * std::log10(first)));
       time(k) < end * (1 - model::same_time); ++k)
    times.push_back(time(k));
  times.push_back(end);
  return times;
}

std::vector<double> default_state_times(double end) {
  std::vector<double> times =
      evenly_spaced(std::min(1e-3, end / 100), end, 7, Spacing::logarithmic);
  times.insert(times.begin(), 0);
  return times;
}

Times read_times(const TomlTable& time, std::string_view states) {
  Times times;
  times.end = time.number("end", above(0));
  const Interval run = between(0, times.end);
  times.exact_rows = time.has("output");
  times.rows = time.grid("output", run, default_row_times(times.end));
  times.states = time.grid(states, run, default_state_times(times.end));
  times.every_step = time.boolean("every_step", times.every_step);
  times.stop_at_rest = time.boolean("stop_at_rest", times.stop_at_rest);
  return times;
}

void write_times(TomlText& toml, const Times& times, std::string_view states) {
  toml.table("time");
  toml.value("end", times.end);
  if (times.exact_rows) toml.value("output", times.rows);
  toml.value(states, times.states);
  toml.value("every_step", times.every_step);
  toml.value("stop_at_rest", times.stop_at_rest);
}

model::FlowSchedule schedule_of(const Times& times) {
  model::FlowSchedule schedule{.end_time = times.end,
                               .output_times = times.exact_rows ? times.rows : std::vector{0.},
                               .stop_at_rest = times.stop_at_rest};
  schedule.output_times.insert(schedule.output_times.end(), times.states.begin(),
                               times.states.end());
  return schedule;
}

bool contains(const std::vector<double>& times, double time) {
  const double slack = model::same_time * time;
  const auto at = std::lower_bound(times.begin(), times.end(), time - slack);
  return at != times.end() && *at <= time + slack;
}

bool row_is_due(const Times& times, const model::FlowRecord& record, bool exact) {
  if (times.every_step) return true;
  if (times.exact_rows) return exact && contains(times.rows, record.time);
  const auto passed = [&](double time) {
    return std::upper_bound(times.rows.begin(), times.rows.end(), time * (1 + model::same_time));
  };
  return record.time_step == 0 || passed(record.time - record.time_step) != passed(record.time);
}

}  // namespace sbeh::studies
