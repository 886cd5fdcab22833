// Observer of a 3D run: frames, with their index for ParaView.
#pragma once

#include "studies/evolution/moment.h"
#include "studies/evolution/state_files.h"

namespace sbeh::studies {

class FrameWriter {
 public:
  /// Keeps the frames up to `until` of an earlier run. Throws OutputError.
  FrameWriter(const OutputFolder& folder, const std::vector<double>& times, double until);

  /// A frame when one is due: whether it was.
  bool see(const Moment& moment, bool exact);
  /// The last frame, unless it is there.
  void finish(const Moment& moment);
  int count() const { return int(files_.entries().size()); }

 private:
  void write_index() const;

  const OutputFolder& folder_;
  StateFiles files_;
};

}  // namespace sbeh::studies
