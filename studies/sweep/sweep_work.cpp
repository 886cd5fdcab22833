#include "studies/sweep/sweep_work.h"

#include "studies/io/child_program.h"
#include "studies/io/file_lock.h"
#include "studies/io/interrupt.h"
#include "studies/io/output.h"
#include "studies/io/progress.h"
#include "studies/io/stopwatch.h"
#include "studies/sweep/sweep_status.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstring>
#include <deque>
#include <list>
#include <sstream>
#include <thread>

namespace sbeh::studies {

namespace fs = std::filesystem;

namespace {

// ---- one case -----------------------------------------------------------------------------------

// An axisymmetric evolution cannot be gone on with: what one that was interrupted has left is in the way.
void clear_evolution(const fs::path& folder) {
  std::error_code ignored;
  for (const char* left : {"series.csv", "profiles.csv"}) remove_file(folder / left);
  fs::remove_all(folder / "profiles", ignored);
}

std::vector<std::string> command_of(const SweepPlan& plan, int number, const WorkOrder& order) {
  std::vector<std::string> words{own_program(),
                                 name(plan.kind),
                                 plan.input_of(number).string(),
                                 "-o",
                                 plan.case_folder(number).string(),
                                 "--threads",
                                 std::to_string(order.threads)};
  if (plan.kind == InputKind::run) words.emplace_back("--resume");
  if (!order.pictures) words.emplace_back("--no-pictures");
  return words;
}

bool was_interrupted(int exit_code) {
  return exit_code == exit_by_signal + SIGINT || exit_code == exit_by_signal + SIGTERM;
}

// The last complaint of the program in what its log has grown by, or else its last line.
std::string last_words(const fs::path& log, std::size_t begin) {
  const std::string text = read_file(log);
  std::istringstream grown(text.substr(std::min(begin, text.size())));
  constexpr std::string_view complaint = "sbeh: ";
  std::string last, complained;
  for (std::string line; std::getline(grown, line);) {
    if (line.starts_with(complaint)) complained = line.substr(complaint.size());
    if (!line.empty()) last = line;
  }
  return complained.empty() ? last : complained;
}

// A case at work: its log, which is its lock, and its process.
class CaseAtWork {
 public:
  CaseAtWork(const SweepPlan& plan, int number, const WorkOrder& order, FileLock lock)
      : plan_(plan),
        number_(number),
        lock_(std::move(lock)),
        begin_(fs::file_size(plan.log_of(number))) {
    if (plan.kind == InputKind::relax) clear_evolution(plan.case_folder(number));
    child_.emplace(command_of(plan, number, order), lock_.descriptor());
  }

  void send(int signal) const { child_->send(signal); }
  /// How the case ended, once its process has; kept, unless it was interrupted.
  std::optional<CaseEnd> ended() {
    const auto exit_code = child_->exit_code();
    if (!exit_code) return {};
    CaseEnd end{.key = number_, .exit_code = *exit_code, .seconds = watch_.seconds(), .reason = {}};
    if (was_interrupted(*exit_code)) return end;
    if (*exit_code > exit_by_signal)
      end.reason = fmt::format("ended by signal {} ({})", *exit_code - exit_by_signal,
                               strsignal(*exit_code - exit_by_signal));
    else if (*exit_code == exit_not_started)
      end.reason = "sbeh could not be started";
    else if (*exit_code != 0)
      end.reason = last_words(plan_.log_of(number_), begin_);
    write_end(plan_, end);
    return end;
  }

 private:
  const SweepPlan& plan_;
  int number_;
  FileLock lock_;
  std::size_t begin_;  // of what this process says
  Stopwatch watch_;
  std::optional<ChildProgram> child_;
};

// ---- all of them --------------------------------------------------------------------------------

class Work {
 public:
  Work(const SweepPlan& plan, const WorkOrder& order)
      : plan_(plan), order_(order), progress_("cases", count_of_part(), there_before()) {}

  WorkSummary run() {
    work_through_open();
    if (!elsewhere_.empty()) {  // perhaps somebody has only looked at them
      std::this_thread::sleep_for(std::chrono::milliseconds(50));
      open_.swap(elsewhere_);
      work_through_open();
    }
    if (interrupt_signal()) end_all();
    progress_.finish();
    summary_.elsewhere = int(elsewhere_.size());
    summary_.interrupted = interrupt_signal() != 0;
    return summary_;
  }

 private:
  int count_of_part() const {
    return int(std::ranges::count_if(
        plan_.cases, [&](const PlannedCase& of) { return order_.part.has(of.number); }));
  }
  // Collects the cases to work on; how many have ended.
  int there_before() {
    int there = 0;
    for (const PlannedCase& of : plan_.cases) {
      if (!order_.part.has(of.number)) continue;
      const CaseStatus status = state_of(plan_, of).status;
      if (status == CaseStatus::open || status == CaseStatus::running) open_.push_back(&of);
      there += status == CaseStatus::done || status == CaseStatus::failed;
    }
    return there;
  }

  void work_through_open() {
    while (!interrupt_signal() && (!open_.empty() || !at_work_.empty())) {
      while (!open_.empty() && int(at_work_.size()) < order_.jobs && !interrupt_signal())
        begin_next();
      look_at_all();
    }
  }

  void begin_next() {
    const PlannedCase& of = *open_.front();
    open_.pop_front();
    const fs::path log = plan_.log_of(of.number);
    auto lock = order_.waits ? FileLock::wait(log) : FileLock::take(log);
    if (!lock) {
      if (!interrupt_signal()) elsewhere_.push_back(&of);
      return;
    }
    if (read_end(plan_, of.number)) return;  // somebody else has just ended it
    at_work_.emplace_back(plan_, of.number, order_, std::move(*lock));
    ++summary_.worked;
  }

  // Takes those away that have ended; waits a little where none has.
  void look_at_all() {
    bool any = false;
    for (auto at = at_work_.begin(); at != at_work_.end();) {
      const auto end = at->ended();
      if (end) tell_end(*end);
      any = any || end;
      at = end ? at_work_.erase(at) : std::next(at);
    }
    if (!any && !at_work_.empty()) std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }

  void tell_end(const CaseEnd& end) {
    if (was_interrupted(end.exit_code)) return;
    if (end.exit_code != 0)
      progress_.say(complaint_about(plan_, {end.key, CaseStatus::failed, end.reason}));
    progress_.advance();
  }

  void end_all() {
    for (const CaseAtWork& one : at_work_) one.send(interrupt_signal());
    while (!at_work_.empty()) look_at_all();
  }

  const SweepPlan& plan_;
  const WorkOrder& order_;
  std::deque<const PlannedCase*> open_, elsewhere_;
  std::list<CaseAtWork> at_work_;
  WorkSummary summary_;
  Progress progress_;  // after open_, which its beginning collects
};

}  // namespace

WorkSummary work_through(const SweepPlan& plan, const WorkOrder& order) {
  return Work(plan, order).run();
}

}  // namespace sbeh::studies
