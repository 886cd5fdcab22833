// How far a sweep is.
#pragma once

#include "model/names.h"
#include "studies/sweep/sweep_folder.h"

#include <array>
#include <string>
#include <vector>

namespace sbeh::studies {

enum class CaseStatus {
  open,     ///< not begun, or interrupted
  running,  ///< somebody works on it
  done,
  failed,  ///< it has ended, but not well
  edited   ///< its input is not what the sweep made it: it is not run
};
constexpr auto names(CaseStatus) {
  return std::array{"open", "running", "done", "failed", "edited"};
}

struct CaseState {
  int number = 0;
  CaseStatus status = CaseStatus::open;
  std::string reason{};  ///< why it failed
};

CaseState state_of(const SweepPlan& plan, const PlannedCase& of);
std::vector<CaseState> states_of(const SweepPlan& plan);

int count_of(const std::vector<CaseState>& states, CaseStatus status);

/// "3 done, 1 failed, 36 open".
std::string counts_text(const std::vector<CaseState>& states);

/// The line of a case that failed or was edited, for people; empty for others.
std::string complaint_about(const SweepPlan& plan, const CaseState& state);

/// Opens failed cases again; how many.
int retry_failed(const SweepPlan& plan);

/// Writes sweep.csv: a row per case with its status, the values of the swept keys, what came out, and why it failed.
/// Others that write it at the same time are waited for. Throws OutputError.
void write_sweep_table(const SweepPlan& plan);

}  // namespace sbeh::studies
