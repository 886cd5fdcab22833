#include "studies/sweep/sweep_status.h"

#include "studies/io/file_lock.h"
#include "studies/io/output.h"

#include <fmt/format.h>

#include <algorithm>

namespace sbeh::studies {

CaseState state_of(const SweepPlan& plan, const PlannedCase& of) {
  CaseState state{.number = of.number};
  const auto end = read_end(plan, of.number);
  if (end) {
    state.status = end->exit_code == 0 ? CaseStatus::done : CaseStatus::failed;
    state.reason = end->reason;
  } else if (FileLock::is_taken(plan.log_of(of.number))) {
    state.status = CaseStatus::running;
  }
  if (state.status != CaseStatus::running && !is_as_made(plan, of))
    state.status = CaseStatus::edited;
  return state;
}

std::vector<CaseState> states_of(const SweepPlan& plan) {
  std::vector<CaseState> states;
  for (const PlannedCase& of : plan.cases) states.push_back(state_of(plan, of));
  return states;
}

int count_of(const std::vector<CaseState>& states, CaseStatus status) {
  return int(std::ranges::count(states, status, &CaseState::status));
}

std::string counts_text(const std::vector<CaseState>& states) {
  using enum CaseStatus;
  std::string text;
  for (const CaseStatus status : {done, failed, edited, running, open})
    if (const int count = count_of(states, status); count > 0)
      text += fmt::format("{}{} {}", text.empty() ? "" : ", ", count, name(status));
  return text;
}

std::string complaint_about(const SweepPlan& plan, const CaseState& state) {
  if (state.status == CaseStatus::failed)
    return fmt::format("case {}: {} (see {})", state.number, state.reason,
                       plan.log_of(state.number).string());
  if (state.status == CaseStatus::edited)
    return fmt::format(
        "case {}: {} is not what the sweep made it, and is not run: put it back, or run it in a "
        "folder of its own",
        state.number, plan.input_of(state.number).string());
  return "";
}

int retry_failed(const SweepPlan& plan) {
  int count = 0;
  for (const CaseState& state : states_of(plan)) {
    if (state.status != CaseStatus::failed) continue;
    remove_file(plan.end_of(state.number));
    ++count;
  }
  return count;
}

}  // namespace sbeh::studies
