// What a 3D run leaves in its folder while it goes on: all its observers.
#pragma once

#include "studies/evolution/checkpoint.h"
#include "studies/evolution/event_log.h"
#include "studies/evolution/flow_progress.h"
#include "studies/evolution/frame_writer.h"
#include "studies/evolution/moment.h"
#include "studies/evolution/run_input.h"
#include "studies/evolution/series_writer.h"

#include <optional>

namespace sbeh::studies {

class RunObservers {
 public:
  /// Of a run that begins, or goes on, at `start`. Of the files of an earlier run what is not later than
  /// `until` stays. Throws OutputError.
  RunObservers(const RunInput& input, const OutputFolder& folder, Moment start, double until);

  /// Lets each of them see the step. False when a signal asks for the end; the checkpoint is written then.
  /// Throws OutputError.
  bool see(const surface3d::FlowRecord& record, const surface3d::State& state,
           const surface3d::StepView& view, bool exact);
  /// The last state: a row and a frame. A run that is to go on later has left its checkpoint.
  void finish(const surface3d::FlowResult& run);

  int frames() const { return frames_.count(); }
  const std::optional<double>& unresolved_from() const { return events_.unresolved_from(); }

 private:
  surface3d::Diagnostics diagnostics() const;

  const RunInput& input_;
  Moment now_;
  ProgressLine line_;
  LongProgress progress_;
  SeriesWriter series_;
  FrameWriter frames_;
  EventLog events_;
  Checkpoint checkpoint_;
};

}  // namespace sbeh::studies
