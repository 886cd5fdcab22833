// Observer of a 3D run: where the clock, or an interruption, leaves the state.
#pragma once

#include "studies/evolution/moment.h"
#include "studies/io/progress.h"

#include <chrono>
#include <filesystem>

namespace sbeh::studies {

/// In the folder of a run.
inline constexpr const char* checkpoint_name = "checkpoint.vtu";

class Checkpoint {
 public:
  Checkpoint(std::filesystem::path file, double minutes, ProgressLine& line);

  /// From time to time. Where there is no room it says so and the run goes on: of its results nothing is
  /// missing.
  void see(const Moment& moment);
  /// At once. Throws OutputError.
  void write(const Moment& moment) const { write_frame(file_, moment); }
  /// Not due for a while: the state is kept elsewhere.
  void put_off() { kept_ = std::chrono::steady_clock::now(); }
  void remove() const;

 private:
  std::filesystem::path file_;
  double minutes_;
  ProgressLine& line_;
  std::chrono::steady_clock::time_point kept_;
};

}  // namespace sbeh::studies
