// Observer of an evolution: whole states in numbered files, with their index.
#pragma once

#include "studies/evolution/frame_file.h"
#include "studies/io/output.h"
#include "studies/io/timed_table.h"

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace sbeh::studies {

/// Files such as frames/0000.vtu, …, and frames.csv (index,time,file).
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
  bool finish(double time, const Write& write);
  const std::vector<FrameEntry>& entries() const { return entries_; }

 private:
  void add(double time, const Write& write);

  const OutputFolder& folder_;
  std::string kind_, extension_;
  const std::vector<double>& times_;
  TimedTable index_;
  std::vector<FrameEntry> entries_;
};

}  // namespace sbeh::studies
