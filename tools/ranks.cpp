#include "tools/ranks.h"

#include "studies/io/errors.h"
#include "surface3d/shared_flow.h"
#include "tools/refusals.h"

#include <fmt/format.h>
#include <sched.h>
#include <sys/sysinfo.h>
#include <tbb/global_control.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <filesystem>

namespace sbeh::tools {

namespace {

// Of the environment; 1 where it is no number or not there.
int number_in(const char* variable) {
  const char* text = std::getenv(variable);
  return text ? std::max(1, std::atoi(text)) : 1;
}

bool is_first_started() {
  for (const char* variable : {"OMPI_COMM_WORLD_RANK", "SLURM_PROCID"})
    if (const char* rank = std::getenv(variable)) return std::atoi(rank) == 0;
  return true;
}

// The cores of a machine among those that run on it.
void share_cores() {
  const int ranks = number_in("OMPI_COMM_WORLD_LOCAL_SIZE");
  static const tbb::global_control threads(tbb::global_control::max_allowed_parallelism,
                                           std::max(1U, unsigned(get_nprocs()) / unsigned(ranks)));
}

// mpirun may have bound this process to one.
void take_all_cores() {
  cpu_set_t cores;
  CPU_ZERO(&cores);
  for (int k = 0; k < get_nprocs_conf(); ++k) CPU_SET(k, &cores);
  sched_setaffinity(0, sizeof cores, &cores);
}

}  // namespace

int started_together() {
  return std::max(number_in("OMPI_COMM_WORLD_SIZE"), number_in("SLURM_STEP_NUM_TASKS"));
}

void become_one_of_many(char** argv) {
  if (started_together() == 1 || surface3d::Ranks::by_mpi()) return;
  const auto other = std::filesystem::read_symlink("/proc/self/exe").parent_path() / "sbeh-mpi";
  const bool is_there = std::filesystem::exists(other);
  if (!is_there && !is_first_started()) std::_Exit(exit_bad_input);  // one of them says why
  if (!is_there)
    throw studies::InputError(fmt::format(
        "started {} times at once, but this sbeh is built for one process: build it with "
        "-DSBEH_MPI=ON (tools/setup mpi), or start it once",
        started_together()));
  execv(other.c_str(), argv);
  throw studies::InputError(fmt::format("{}: cannot be started", other.string()));
}

RanksAtWork::RanksAtWork() {
  if (started_together() == 1) return;
  ranks_ = surface3d::Ranks::all();
  if (ranks_.is_alone())
    throw studies::InputError(
        fmt::format("started {} times at once, but MPI knows of one process: use the mpirun of the "
                    "MPI that sbeh is built with",
                    started_together()));
  if (!is_first()) share_cores();
}

RanksAtWork::~RanksAtWork() {
  if (ranks_.is_alone()) return;
  if (ranks_.is_first()) surface3d::dismiss(ranks_);
  surface3d::part_with(ranks_);
}

void RanksAtWork::serve() const {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP})  // the first one decides
    std::signal(signal, SIG_IGN);
  surface3d::serve_first(ranks_);
}

void RanksAtWork::begin(const std::string& command) {
  if (ranks_.is_alone()) return;
  if (command == "run") return share_cores();
  if (command != "states")
    throw studies::InputError(fmt::format(
        "{} is for one process, and was started {} times at once: only run and states are "
        "shared by several (a scan has --part, sbeh sweep many cases)",
        command, ranks_.count()));
  take_all_cores();  // the others sleep while nothing is factored
  factors_.emplace(ranks_);
}

}  // namespace sbeh::tools
