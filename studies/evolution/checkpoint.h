// Where the clock, or an interruption, leaves the state of a 3D run, and what of it a run goes on from.
#pragma once

#include "studies/evolution/frame_file.h"
#include "studies/evolution/run_input.h"
#include "studies/io/output.h"
#include "studies/io/progress.h"
#include "studies/io/stopwatch.h"

namespace sbeh::studies {

/// Observer of a 3D run, for checkpoint.vtu in its folder.
class Checkpoint {
 public:
  Checkpoint(const OutputFolder& folder, double minutes, ProgressLine& line);

  /// From time to time. Where there is no room it says so and the run goes on: of its results nothing is
  /// missing.
  void see(const FlowMoment& moment);
  /// At once. Throws OutputError.
  void write(const FlowMoment& moment) const { write_frame(file_, moment); }
  /// Not due for a while: the state is kept elsewhere.
  void put_off() { since_kept_ = {}; }
  void remove() const { remove_file(file_); }

 private:
  std::filesystem::path file_;
  double minutes_;
  ProgressLine& line_;
  Stopwatch since_kept_;
};

/// The newest state of the run in the folder, which has this description; empty for a run from the start.
/// Throws OutputError when the folder holds what must not be overwritten.
std::optional<FlowMoment> moment_to_resume(const RunInput& input, const OutputFolder& folder,
                                           const std::string& description, bool resume);

}  // namespace sbeh::studies
