// Observers of an evolution: the rows of series.csv, and whole states in numbered files.
#pragma once

#include "studies/evolution/times.h"
#include "studies/io/growing_table.h"
#include "studies/states/series_file.h"

#include <functional>

namespace sbeh::studies {

class SeriesWriter {
 public:
  /// Keeps the rows up to `until` of an earlier run, by default none. Throws OutputError.
  SeriesWriter(const OutputFolder& folder, const Times& times, double until = -1)
      : times_(times), table_(folder / "series.csv", header_of(series_columns()), until) {}

  /// A row where one is due, with what `diagnose()` gives.
  void see(const model::FlowRecord& record, bool exact, auto&& diagnose) {
    if (row_is_due(times_, record, exact)) add(record, diagnose());
  }
  /// The last row, unless it is there.
  void finish(const model::FlowRecord& record, auto&& diagnose) {
    if (record.time != table_.last_time()) add(record, diagnose());
  }

 private:
  void add(const model::FlowRecord& record, const auto& diagnostics) {
    table_.append(record.time, line_of(series_columns(), series_row(record, diagnostics)));
  }

  const Times& times_;
  TimedTable table_;
};

/// A row of frames.csv, or of profiles.csv of an axisymmetric run.
struct FrameEntry {
  double time;
  std::string file;  ///< relative to the folder
  int index = 0;
};
const Columns<FrameEntry>& frame_columns();

/// Files such as frames/0000.vtu, …, and frames.csv (index,time,file); of frames also run.pvd, their index
/// for ParaView.
class StateFiles {
 public:
  using Write = std::function<void(const std::filesystem::path&)>;

  /// Of a kind such as "frames" with files such as ".vtu", at these times. Keeps those up to `until` of an
  /// earlier run, by default none. Throws OutputError.
  StateFiles(const OutputFolder& folder, std::string kind, std::string extension,
             const std::vector<double>& times, double until = -1);

  /// Lets `write` make a file when one is due: whether it was.
  bool see(double time, bool exact, const Write& write);
  /// The same for the last state, unless it is there.
  void finish(double time, const Write& write);
  const std::vector<FrameEntry>& entries() const { return entries_; }

 private:
  void add(double time, const Write& write);
  void write_index() const;

  const OutputFolder& folder_;
  std::string kind_, extension_;
  const std::vector<double>& times_;
  TimedTable table_;
  std::vector<FrameEntry> entries_;
};

}  // namespace sbeh::studies
