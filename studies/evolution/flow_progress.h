// Observer of an evolution: how far it is.
#pragma once

#include "model/time/flow_record.h"
#include "studies/io/progress.h"

#include <string>

namespace sbeh::studies {

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
  Stopwatch watch_;
};

}  // namespace sbeh::studies
