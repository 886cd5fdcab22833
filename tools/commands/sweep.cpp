// `sbeh sweep`: an input with values that take turns, as many cases.
#include "studies/io/child_program.h"
#include "studies/io/errors.h"
#include "studies/io/interrupt.h"
#include "studies/report/path_kind.h"
#include "studies/sweep/sweep_slurm.h"
#include "studies/sweep/sweep_status.h"
#include "studies/sweep/sweep_work.h"
#include "tools/commands/commands.h"

#include <algorithm>
#include <numeric>
#include <thread>

namespace sbeh::tools {

namespace {

namespace fs = std::filesystem;
using studies::CaseStatus;
using studies::SweepPlan;

struct SweepWords {
  std::string path, folder, part;
  int jobs = 0, threads = 0;
  bool status = false, retry = false, table = false, slurm = false, dry_run = false;
  bool pictures = false;
};

std::string cases_text(auto count) {
  return fmt::format("{} case{}", count, count == 1 ? "" : "s");
}

// ---- making -------------------------------------------------------------------------------------

double seconds_of(const SweepPlan& plan) {
  return std::accumulate(
      plan.cases.begin(), plan.cases.end(), 0.,
      [](double sum, const studies::PlannedCase& of) { return sum + of.cost.seconds; });
}

int make_folder(const SweepWords& words) {
  for (const bool given : {words.status, words.retry, words.table, words.slurm, words.pictures,
                           !words.part.empty(), words.jobs > 0, words.threads > 0})
    if (given)
      throw studies::InputError(fmt::format(
          "{}: is an input: sbeh sweep {} makes a folder of it, to which the other options belong",
          words.path, words.path));
  const Study study{.input = words.path, .folder = words.folder};
  const auto made =
      studies::make_sweep(studies::read_sweep(words.path), study.results(), SBEH_VERSION);
  const std::string folder = study.results().string();
  fmt::print("{} of sbeh {} {} {}, about {} of one core; to run them: sbeh sweep {}\n",
             cases_text(made.plan.cases.size()), sbeh::name(made.plan.kind),
             made.was_there ? "already there in" : "in", folder, duration(seconds_of(made.plan)),
             folder);
  return 0;
}

// ---- working ------------------------------------------------------------------------------------

studies::WorkOrder order_of(const SweepWords& words, const SweepPlan& plan) {
  const int cores = std::max(1, int(std::thread::hardware_concurrency()));
  studies::WorkOrder order{.pictures = words.pictures};
  if (!words.part.empty()) {
    order.part = part_of(words.part);
    order.waits = true;
  }
  const int by_default = order.waits ? 1 : std::min(cores, int(plan.cases.size()));
  order.jobs = words.jobs > 0 ? words.jobs : by_default;
  order.threads = words.threads > 0 ? words.threads : std::max(1, cores / order.jobs);
  return order;
}

int work(const SweepWords& words, const SweepPlan& plan) {
  const studies::WorkOrder order = order_of(words, plan);
  const studies::WorkSummary summary = studies::work_through(plan, order);
  if (summary.interrupted) {
    complain("interrupted; the same command goes on from here");
    return exit_code_of_interrupt();
  }
  std::vector<studies::CaseState> states = studies::states_of(plan);
  std::erase_if(states,
                [&](const studies::CaseState& state) { return !order.part.has(state.number); });
  if (words.part.empty()) studies::write_sweep_table(plan);
  fmt::print(
      "{} in {}: {}{}\n", cases_text(states.size()), plan.folder.string(),
      studies::counts_text(states),
      words.part.empty() ? fmt::format("; all in {}", (plan.folder / "sweep.csv").string()) : "");
  for (const studies::CaseState& state : states)
    if (state.status == CaseStatus::edited) complain(studies::complaint_about(plan, state));
  if (const int failed = studies::count_of(states, CaseStatus::failed); failed > 0)
    complain(fmt::format("{0} failed: sbeh sweep {1} --status says why, --retry runs them again",
                         failed, plan.folder.string()));
  if (summary.elsewhere > 0)
    complain(fmt::format("somebody else works on {}; sbeh sweep {} --status says how far they are",
                         cases_text(summary.elsewhere), plan.folder.string()));
  const int wrong = studies::count_of(states, CaseStatus::failed)
                  + studies::count_of(states, CaseStatus::edited)
                  + studies::count_of(states, CaseStatus::open);
  return wrong > 0 ? exit_failed : exit_code_of_success();
}

// ---- other things to do with a folder -----------------------------------------------------------

int tell_status(const SweepPlan& plan) {
  const std::vector<studies::CaseState> states = studies::states_of(plan);
  fmt::print("{} of sbeh {} in {}: {}\n", cases_text(states.size()), sbeh::name(plan.kind),
             plan.folder.string(), studies::counts_text(states));
  for (const studies::CaseState& state : states)
    if (const std::string wrong = studies::complaint_about(plan, state); !wrong.empty())
      fmt::print("{}\n", wrong);
  return 0;
}

int write_table(const SweepPlan& plan) {
  studies::write_sweep_table(plan);
  fmt::print("{} in {}: {}\n", cases_text(plan.cases.size()), (plan.folder / "sweep.csv").string(),
             studies::counts_text(studies::states_of(plan)));
  return 0;
}

int by_slurm(const SweepWords& words, const SweepPlan& plan) {
  const auto scripts = studies::write_slurm_scripts(
      plan, {.program = studies::own_program(), .threads = words.threads, .jobs = words.jobs});
  if (scripts.tasks == 0) {
    fmt::print("nothing to submit: {}\n", studies::counts_text(studies::states_of(plan)));
    return 0;
  }
  if (words.dry_run) {
    fmt::print("{} as {} tasks: {}, and after them {}\n", cases_text(scripts.cases), scripts.tasks,
               scripts.array.string(), scripts.table.string());
    return 0;
  }
  const studies::SlurmJobs jobs = studies::submit(scripts);
  fmt::print("submitted {} as {} tasks, job {}, and the table as job {}\n",
             cases_text(scripts.cases), scripts.tasks, jobs.array, jobs.table);
  return 0;
}

int sweep(const SweepWords& words) {
  std::error_code ignored;
  if (!fs::is_directory(words.path, ignored)) return make_folder(words);
  if (!words.folder.empty())
    throw studies::InputError(
        fmt::format("-o {}: belongs to an input; {} is a folder", words.folder, words.path));
  const SweepPlan plan = studies::read_plan(words.path);
  if (words.status) return tell_status(plan);
  if (words.table) return write_table(plan);
  if (words.retry) fmt::print("{} tried again\n", cases_text(studies::retry_failed(plan)));
  return words.slurm ? by_slurm(words, plan) : work(words, plan);
}

}  // namespace

Command add_sweep(CLI::App& program) {
  const auto words = std::make_shared<SweepWords>();
  CLI::App* app = program.add_subcommand(
      "sweep", "an input with values that take turns: many cases, here or by Slurm");
  app->add_option("PATH", words->path,
                  "input (TOML) of which a folder of cases is made; or such a folder, whose open "
                  "cases are run")
      ->required();
  app->add_option("-o,--output", words->folder, "the folder to make (results/NAME)");
  app->add_option("--jobs", words->jobs, "so many cases at once (all cores)")
      ->check(CLI::Range(1, 4096));
  app->add_option("--threads", words->threads, "of each case (cores divided by jobs)")
      ->check(CLI::Range(1, 4096));
  app->add_flag("--pictures", words->pictures, "draw those of each case");
  CLI::Option* status = app->add_flag("--status", words->status,
                                      "say how many cases are done, and which failed and why");
  CLI::Option* table = app->add_flag("--table", words->table, "only write sweep.csv");
  CLI::Option* retry = app->add_flag("--retry", words->retry, "run failed cases again");
  CLI::Option* part = app->add_option(
      "--part", words->part,
      "only every N-th case from the K-th on, K/N; waits for others at work on them");
  CLI::Option* slurm = app->add_flag("--slurm", words->slurm,
                                     "submit the open cases to Slurm, and the table after them");
  for (CLI::Option* other : {table, retry, part, slurm}) status->excludes(other);
  for (CLI::Option* other : {retry, part, slurm}) table->excludes(other);
  part->excludes(slurm);
  app->add_flag("--dry-run", words->dry_run, "with --slurm: only write what would be submitted")
      ->needs("--slurm");
  return {app, [words] {
            studies::catch_interrupts();
            try {
              return sweep(*words);
            } catch (const studies::InputError&) {
              if (!fs::is_directory(words->path)) studies::refuse_other_kind(words->path, "sweep");
              throw;
            }
          }};
}

void check_sweep(const std::string& file) {
  const studies::SweepInput input = studies::read_sweep(file);
  const studies::SweepCases cases = studies::cases_of(input, SBEH_VERSION);
  double seconds = 0, megabytes = 0;
  for (const studies::SweepCase& of : cases.cases) {
    seconds += of.cost.seconds;
    megabytes = std::max(megabytes, of.cost.megabytes);
  }
  fmt::print(
      "{}: a sweep of {} of sbeh {}, about {} of one core and {:.0f} MB of memory for a "
      "case\n\n{}",
      file, cases_text(cases.cases.size()), sbeh::name(cases.kind), duration(seconds), megabytes,
      studies::plan_text(studies::swept_keys(input), cases));
}

}  // namespace sbeh::tools
