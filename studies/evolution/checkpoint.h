// Where the clock, or an interruption, leaves the state of a 3D run.
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
  static constexpr const char* file_name = "checkpoint.vtu";

  Checkpoint(const OutputFolder& folder, const RunInput& input, ProgressLine& line);

  /// From time to time. Where there is no room it says so and the run goes on: of its results nothing is
  /// missing.
  void see(const FlowMoment& moment);
  /// At once. Throws OutputError.
  void write(const FlowMoment& moment) const { write_frame(file_, moment, input_); }
  /// Not due for a while: the state is kept elsewhere.
  void put_off() { since_kept_ = {}; }
  void remove() const { remove_file(file_); }

 private:
  std::filesystem::path file_;
  const RunInput& input_;
  ProgressLine& line_;
  Stopwatch since_kept_;
};

}  // namespace sbeh::studies
