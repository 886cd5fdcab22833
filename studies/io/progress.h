// What is said to the user while work goes on.
#pragma once

#include "studies/io/stopwatch.h"

#include <functional>
#include <optional>
#include <string_view>

namespace sbeh::studies {

/// Writes to standard error. A log that cannot take it, such as on a full disk, ends no work.
void tell(std::string_view text);

/// From now on gives what is told to `listener` instead, from any thread, one at a time; it is a terminal or a log. Without
/// one, to standard error again.
void tell_to(std::function<void(std::string_view)> listener, bool terminal);

/// How far something is: on a terminal one line that is rewritten, in a log one line after the other. Writes
/// to standard error.
class ProgressLine {
 public:
  ProgressLine();
  /// Ends the line.
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  bool on_terminal() const { return terminal_; }
  /// Seconds since the line was shown; infinite before.
  double age() const;
  void show(std::string_view text);
  /// A message of its own.
  void say(std::string_view message);
  /// Ends the line before other output follows.
  void end();

 private:
  const bool terminal_;
  bool open_ = false;  // on a terminal: the line is there
  std::optional<Stopwatch> shown_;
};

/// How far a scan is: on a terminal always, otherwise for every tenth of the work.
class Progress {
 public:
  /// `done` of `total` pieces are there from an earlier run; they do not count for the rate.
  Progress(std::string_view unit, int total, int done);
  /// One more piece is done. Not thread-safe.
  void advance();
  /// A message among the progress lines.
  void say(std::string_view message) { line_.say(message); }
  /// Ends the line.
  void finish() { line_.end(); }

 private:
  bool due() const;
  void show();

  ProgressLine line_;
  std::string_view unit_;
  int total_, done_, before_, shown_tenths_ = 0;
  Stopwatch watch_;
};

}  // namespace sbeh::studies
