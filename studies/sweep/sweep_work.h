// Working through the cases of a sweep on this machine, so many at once.
#pragma once

#include "studies/io/part.h"
#include "studies/sweep/sweep_folder.h"

namespace sbeh::studies {

struct WorkOrder {
  int jobs = 1;           ///< cases at once
  int threads = 1;        ///< of each
  bool pictures = false;  ///< drawn for each
  Part part{};            ///< of the cases, by their numbers
  /// Cases that somebody else works on are waited for, and then looked at; otherwise they are left to him.
  bool waits = false;
};

struct WorkSummary {
  int worked = 0;     ///< cases, in this call
  int elsewhere = 0;  ///< on which somebody else works
  bool interrupted = false;
};

/// Runs the open cases, each as a process of this program, which goes on with what is there, into its own log. However
/// it ends, a case is never worked on twice at a time, and not again once it is done. Signals are handed on to the
/// cases; they are then open as before. Progress and failures on standard error. Throws OutputError.
WorkSummary work_through(const SweepPlan& plan, const WorkOrder& order);

}  // namespace sbeh::studies
