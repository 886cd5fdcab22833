#include "studies/sweep/sweep_slurm.h"

#include "studies/io/child_program.h"
#include "studies/io/output.h"
#include "studies/sweep/sweep_status.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace sbeh::studies {

namespace fs = std::filesystem;

namespace {

constexpr int most_tasks = 1000;  // of an array, unless Slurm is told otherwise (MaxArraySize)

// Estimates are good to a factor of two or so; a job beyond them is ended, and has to go on in another.
constexpr double spare_time = 4, spare_memory = 2, least_minutes = 10, least_megabytes = 200;

// What one task needs: of its cases the sum of the times, and the most of memory and cores.
struct TaskNeeds {
  double minutes = 0, megabytes = 0;
  int cores = 1;
};

TaskNeeds operator+(const TaskNeeds& needs, const CaseCost& cost) {
  return {needs.minutes + spare_time * cost.seconds / 60 / cost.cores,
          std::max(needs.megabytes, spare_memory * cost.megabytes),
          std::max(needs.cores, cost.cores)};
}

// By the numbers of the tasks that have open cases.
std::map<int, TaskNeeds> open_tasks(const SweepPlan& plan, int parts) {
  std::map<int, TaskNeeds> tasks;
  for (const PlannedCase& of : plan.cases) {
    if (state_of(plan, of).status != CaseStatus::open) continue;
    TaskNeeds& task = tasks[(of.number - 1) % parts + 1];
    task = task + of.cost;
  }
  return tasks;
}

// In single quotes, for the shell.
std::string quoted(const std::string& text) {
  std::string inside;
  for (const char letter : text) inside += letter == '\'' ? "'\\''" : std::string(1, letter);
  return fmt::format("'{}'", inside);
}

std::string head(const SweepPlan& plan, const char* job, const char* output) {
  const fs::path folder = fs::absolute(plan.folder).lexically_normal();
  return fmt::format(
      "#!/bin/sh\n"
      "#SBATCH --job-name=\"{}{}\"\n"
      "#SBATCH --chdir=\"{}\"\n"
      "#SBATCH --output=\"{}\"\n"
      "#SBATCH --open-mode=append\n"
      "#SBATCH --requeue\n",
      folder.filename().string(), job, fs::current_path().string(),
      (folder / "logs" / output).string());
}

std::string array_text(const SweepPlan& plan, const SlurmOrder& order,
                       const std::map<int, TaskNeeds>& tasks, int parts) {
  std::vector<int> numbers;
  TaskNeeds most{least_minutes, least_megabytes, 1};
  for (const auto& [number, needs] : tasks) {
    numbers.push_back(number);
    most = {std::max(most.minutes, needs.minutes), std::max(most.megabytes, needs.megabytes),
            std::max(most.cores, needs.cores)};
  }
  if (order.threads > 0) most.cores = order.threads;
  return head(plan, "", "slurm-%a.txt")
       + fmt::format(
             "#SBATCH --array={}{}\n"
             "#SBATCH --time={:.0f}\n"
             "#SBATCH --mem={:.0f}M\n"
             "#SBATCH --cpus-per-task={}\n"
             "#SBATCH --signal=B:TERM@60\n"
             "exec {} sweep {} --part \"$SLURM_ARRAY_TASK_ID/{}\" --threads {}\n",
             ranges_text(numbers), order.jobs > 0 ? fmt::format("%{}", order.jobs) : "",
             std::ceil(most.minutes), std::ceil(most.megabytes), most.cores, quoted(order.program),
             quoted(plan.folder.string()), parts, most.cores);
}

std::string table_text_of(const SweepPlan& plan, const SlurmOrder& order) {
  return head(plan, " table", "slurm-table.txt")
       + fmt::format(
             "#SBATCH --time={:.0f}\n"
             "#SBATCH --mem={:.0f}M\n"
             "exec {} sweep {} --table\n",
             least_minutes, least_megabytes, quoted(order.program), quoted(plan.folder.string()));
}

// The number of the job.
std::string submitted(const fs::path& script, const std::vector<std::string>& options) {
  std::vector<std::string> words{"sbatch", "--parsable"};
  words.insert(words.end(), options.begin(), options.end());
  words.push_back(script.string());
  const ChildAnswer answer = answer_of(words);
  if (answer.exit_code == exit_not_started)
    throw InputError(
        fmt::format("sbatch is not there: is this a machine from which jobs of Slurm are "
                    "submitted? There: sbatch {}",
                    script.string()));
  if (answer.exit_code != 0)
    throw InputError(fmt::format(
        "{}: sbatch refuses it, see above; change what it asks for, and submit it by: sbatch {}",
        script.string(), script.string()));
  return answer.said.substr(0, answer.said.find_first_of(";\n"));
}

}  // namespace

SlurmScripts write_slurm_scripts(const SweepPlan& plan, const SlurmOrder& order) {
  const int parts = std::min(int(plan.cases.size()), most_tasks);
  const std::map<int, TaskNeeds> tasks = open_tasks(plan, parts);
  SlurmScripts scripts{.array = plan.folder / "sweep.sbatch",
                       .table = plan.folder / "table.sbatch"};
  scripts.cases = count_of(states_of(plan), CaseStatus::open);
  scripts.tasks = int(tasks.size());
  if (scripts.tasks == 0) return scripts;
  write_file(scripts.array, array_text(plan, order, tasks, parts));
  write_file(scripts.table, table_text_of(plan, order));
  return scripts;
}

SlurmJobs submit(const SlurmScripts& scripts) {
  SlurmJobs jobs{.array = submitted(scripts.array, {}), .table = {}};
  const std::string after = "--dependency=afterany:" + jobs.array;
  try {
    jobs.table = submitted(scripts.table, {after});
  } catch (const InputError& error) {
    throw InputError(
        fmt::format("job {} runs the cases, but: {} (with {})", jobs.array, error.what(), after));
  }
  return jobs;
}

std::string ranges_text(const std::vector<int>& numbers) {
  std::string text;
  for (std::size_t k = 0; k < numbers.size();) {
    std::size_t last = k;
    while (last + 1 < numbers.size() && numbers[last + 1] == numbers[last] + 1) ++last;
    text += text.empty() ? "" : ",";
    text +=
        last == k ? std::to_string(numbers[k]) : fmt::format("{}-{}", numbers[k], numbers[last]);
    k = last + 1;
  }
  return text;
}

}  // namespace sbeh::studies
