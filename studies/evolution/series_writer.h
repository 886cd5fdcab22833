// Observer of an evolution: the rows of series.csv.
#pragma once

#include "studies/evolution/times.h"
#include "studies/io/timed_table.h"
#include "studies/states/series_file.h"

namespace sbeh::studies {

class SeriesWriter {
 public:
  /// Keeps the rows up to `until` of an earlier run, by default none. Throws OutputError.
  SeriesWriter(const OutputFolder& folder, const Times& times, double until = -1)
      : times_(times), table_(folder / "series.csv", header_of(series_columns()), until) {}

  /// A row where one is due, with what `diagnose()` gives.
  void see(const model::FlowRecord& record, bool exact, auto&& diagnose) {
    if (times_.every_step || (exact && contains(times_.rows, record.time)))
      table_.append(record.time, series_line(record, diagnose()));
  }
  /// The last row, unless it is there.
  void finish(const model::FlowRecord& record, auto&& diagnose) {
    if (record.time != table_.last_time())
      table_.append(record.time, series_line(record, diagnose()));
  }

 private:
  const Times& times_;
  TimedTable table_;
};

}  // namespace sbeh::studies
