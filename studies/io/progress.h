// What is said to the user while work goes on.
#pragma once

#include <chrono>
#include <string_view>

namespace sbeh::studies {

/// Writes to standard error. A log that cannot take it, such as on a full disk, ends no work.
void tell(std::string_view text);

/// How far a scan is: on a terminal one line that is rewritten, otherwise a line for every tenth of
/// the work. Writes to standard error.
class Progress {
 public:
  /// `done` of `total` pieces are there from an earlier run; they do not count for the rate.
  Progress(std::string_view unit, int total, int done);
  /// One more piece is done. Not thread-safe.
  void advance();
  /// A message among the progress lines.
  void say(std::string_view message);
  /// Ends the line.
  void finish();

 private:
  void show();
  std::string_view unit_;
  int total_, done_, before_, shown_tenths_ = 0;
  bool terminal_;
  std::chrono::steady_clock::time_point start_, shown_;
};

}  // namespace sbeh::studies
