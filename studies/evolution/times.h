// The table [time] of an evolution: until when it goes, and when something is written.
#pragma once

#include "model/time/step_control.h"
#include "studies/io/toml_reader.h"
#include "studies/io/toml_text.h"

#include <string_view>
#include <vector>

namespace sbeh::studies {

struct Times {
  double end = 0;            ///< > 0
  std::vector<double> rows;  ///< key `output`: rows of series.csv; 0 … end, ascending
  bool exact_rows = true;    ///< else, without the key, each at the end of the step that passes it
  std::vector<double> states;  ///< key `profiles` or `frames`: whole states; likewise
  bool every_step = false;     ///< a row after each step too
  bool stop_at_rest = true;    ///< end before `end` when nothing moves any more

  bool operator==(const Times&) const = default;
};

/// `states` is the key of the times of whole states. Throws InputError; other keys are the caller's.
Times read_times(const TomlTable& time, std::string_view states);
void write_times(TomlText& toml, const Times& times, std::string_view states);

/// 0, `end`, and between them, from 1e-5 or, if smaller, end/100 on, 32 in a decade in equal ratios, among them its power of 10: a later end adds
/// to them.
std::vector<double> default_row_times(double end);
/// 0, `end` and 6 times in equal ratios between, from 1e-3 or, if smaller, end/100.
std::vector<double> default_state_times(double end);

/// The flow that meets the times of states, and the exact ones of rows.
model::FlowSchedule schedule_of(const Times& times);

/// Whether a row is due at the end of a step; `exact`: it ends at a time of the schedule.
bool row_is_due(const Times& times, const model::FlowRecord& record, bool exact);

/// Whether a time is one of these, ascending: the same number, perhaps reached by another sum.
bool contains(const std::vector<double>& times, double time);

}  // namespace sbeh::studies
