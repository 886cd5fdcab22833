// A sweep as an array job of Slurm, and a job that makes its table when all tasks have ended.
#pragma once

#include "studies/sweep/sweep_folder.h"

#include <optional>
#include <string>
#include <vector>

namespace sbeh::studies {

struct SlurmOrder {
  std::string program;  ///< with its whole path
  int threads = 0;      ///< of each case; 0: as many as its cost asks for
  int jobs = 0;         ///< tasks at once; 0: as many as Slurm runs
};

/// The two scripts, in the folder of the sweep.
struct SlurmScripts {
  std::filesystem::path array, table;
  int cases = 0;  ///< that are open
  int tasks = 0;  ///< a case each, or several where Slurm's arrays are not long enough
};
/// Writes them for the cases that are open. Time, memory and cores are those of the dearest task, with some to spare.
/// Throws OutputError.
SlurmScripts write_slurm_scripts(const SweepPlan& plan, const SlurmOrder& order);

struct SlurmJobs {
  std::string array, table;  ///< their numbers
};
/// Submits them, the table after all tasks, however these end. Throws InputError where there is no sbatch, or where it
/// refuses.
SlurmJobs submit(const SlurmScripts& scripts);

/// "1-3,7": numbers in ascending order, as Slurm lists them.
std::string ranges_text(const std::vector<int>& numbers);

}  // namespace sbeh::studies
