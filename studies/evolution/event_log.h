// Observer of a 3D run: its events, in events.csv and among the messages.
#pragma once

#include "studies/io/growing_table.h"
#include "studies/io/output.h"
#include "studies/io/progress.h"
#include "surface3d/flow.h"

#include <optional>
#include <string>

namespace sbeh::studies {

/// A row of events.csv.
struct EventRow {
  double time;
  std::string event;  ///< "unresolved", "resolved" (again), "remeshed" or "not-remeshed"
  int triangles;
  surface3d::Indicators indicators;  ///< before
  surface3d::RemeshReport report;    ///< of new triangles
};
const Columns<EventRow>& event_columns();

/// Which limits of `surface3d::resolved` are passed, in words.
std::string passed_limits(const surface3d::Indicators& indicators);

/// A mesh that is or is not replaced, and the times from which a mesh that stays is too coarse and no longer is.
class EventLog {
 public:
  /// `remesh`: whether meshes may be replaced. Keeps the events up to `until` of an earlier run. Throws
  /// OutputError.
  EventLog(const OutputFolder& folder, bool remesh, double until, ProgressLine& line);

  void see(const surface3d::FlowRecord& record, const surface3d::StepView& view);
  /// The first time at which the mesh did not resolve the surface; empty when it always did.
  const std::optional<double>& unresolved_from() const { return unresolved_from_; }

 private:
  void append(const EventRow& event);
  void see_new_mesh(double time, const surface3d::Indicators& before,
                    const surface3d::RemeshResult& made);

  TimedTable table_;
  bool remesh_;
  ProgressLine& line_;
  bool resolved_ = true;  // by the last event that says so
  std::optional<double> unresolved_from_;
};

}  // namespace sbeh::studies
