// What a 3D run leaves in its folder while it goes on.
#pragma once

#include "studies/evolution/frame_file.h"
#include "studies/evolution/run_input.h"
#include "studies/io/output.h"

#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace sbeh::studies {

/// Where an interrupted run, or the clock, leaves the state.
inline constexpr const char* checkpoint_name = "checkpoint.vtu";

/// Observer of surface3d::run_flow: writes series.csv, frames/*.vtu with frames.csv and run.pvd at the
/// times asked for, events.csv, and checkpoints; shows the progress on standard error.
class RunRecorder {
 public:
  /// In a folder that holds a run, its rows up to `resumed_at` stay; without it, none. Throws OutputError.
  RunRecorder(const RunInput& input, const surface3d::Target& target,
              std::shared_ptr<const surface3d::Triangulation> mesh, const OutputFolder& folder,
              std::optional<double> resumed_at);

  /// False when a signal asks for the end; the checkpoint is written then. Throws OutputError.
  bool operator()(const surface3d::FlowRecord& record, const surface3d::State& state,
                  const surface3d::StepView& view, bool exact);

  /// The last state: a row and a frame. A run that is to go on later has left its checkpoint.
  void finish(const surface3d::FlowResult& run);

  int frames() const { return int(frames_.size()); }
  /// The time from which the mesh did not resolve the surface; empty when it always did.
  const std::optional<double>& unresolved_from() const { return unresolved_from_; }

 private:
  struct Look {  // what of a StepView outlives the step
    surface3d::StepFields fields;
    surface3d::FlowMemory memory;
  };
  void write_row(const surface3d::FlowRecord& record, const surface3d::State& state);
  void write(const std::filesystem::path& path, const surface3d::FlowRecord& record,
             const surface3d::State& state) const;
  void write_frame_of(const surface3d::FlowRecord& record, const surface3d::State& state);
  void note_events(const surface3d::FlowRecord& record, const surface3d::StepView& view);
  void keep(const surface3d::FlowRecord& record, const surface3d::State& state);
  void show(const surface3d::FlowRecord& record);
  void say(const std::string& line) const;  // below the progress line

  const RunInput& input_;
  surface3d::Target target_;
  std::shared_ptr<const surface3d::Triangulation> mesh_;
  const OutputFolder& folder_;
  std::unique_ptr<AppendFile> series_, index_, events_;
  std::vector<FrameEntry> frames_;
  Look last_;
  const bool terminal_;
  std::chrono::steady_clock::time_point began_, shown_;
  std::chrono::steady_clock::time_point kept_;  // when the last frame or checkpoint was written
  int steps_ = 0;
  double last_row_ = -1, last_frame_ = -1;
  std::optional<double> unresolved_from_;
};

}  // namespace sbeh::studies
