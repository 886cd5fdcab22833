// Observer of an evolution: how far it is.
#pragma once

#include "model/time/flow_record.h"
#include "studies/io/progress.h"

#include <deque>
#include <optional>
#include <string>

namespace sbeh::studies {

/// How long an evolution has still to go, by the rate of its latest steps. Not known where these are few, or where steps change so fast
/// that their rate tells nothing of later ones, as at the start and on new triangles.
class TimeLeft {
 public:
  /// A step has led to the time `time`, `seconds` of wall time after any fixed moment.
  void see(double time, double seconds);
  /// Seconds; at least 0.
  std::optional<double> until(double end) const;

 private:
  struct Moment {
    double time, seconds;
  };
  std::deque<Moment> latest_;  // the oldest first
};

/// Of a short run: only on a terminal.
class BriefProgress {
 public:
  explicit BriefProgress(double end_time, std::string name = "")
      : name_(std::move(name)), end_time_(end_time) {}
  void see(const model::FlowRecord& record);
  void finish() { line_.end(); }

 private:
  ProgressLine line_;
  std::string name_;
  double end_time_;
};

/// Of a long run: with its speed, and in a log every minute.
class LongProgress {
 public:
  LongProgress(ProgressLine& line, double end_time) : line_(line), end_time_(end_time) {}
  void see(const model::FlowRecord& record);

 private:
  ProgressLine& line_;
  double end_time_;
  int steps_ = 0;
  TimeLeft left_;
  Stopwatch watch_;
};

}  // namespace sbeh::studies
