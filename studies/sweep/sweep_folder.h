// The folder of a sweep: its plan, its cases, and how each of them has ended.
//
//   plan.csv         a row per case: its command, what it costs, a checksum of its input, and the values of the swept keys
//   cases/0001/      a folder of the command, with run.toml from the beginning on
//   logs/0001.txt    what the command said; locked while the case is worked on
//   ended/0001.csv   exit code, seconds and reason, once it has ended by itself
//   sweep.csv        inputs and results
#pragma once

#include "studies/sweep/sweep_input.h"

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace sbeh::studies {

struct PlannedCase {
  int number = 0;
  InputKind kind = InputKind::run;  ///< the same of all
  CaseCost cost;
  std::string checksum;             ///< of its input
  std::vector<std::string> values;  ///< of the plan's keys, as they stand in files
};

struct SweepPlan {
  std::filesystem::path folder;
  InputKind kind = InputKind::run;
  std::vector<std::string> keys;
  std::vector<PlannedCase> cases;

  std::filesystem::path case_folder(int number) const;
  std::filesystem::path input_of(int number) const;
  std::filesystem::path results_of(int number) const;  ///< the table that its command writes
  std::filesystem::path log_of(int number) const;
  std::filesystem::path end_of(int number) const;
};

/// Whether the folder is that of a sweep.
bool holds_sweep(const std::filesystem::path& folder);

/// The plan of a folder. Throws InputError where it holds none, and OutputError where it is damaged.
SweepPlan read_plan(const std::filesystem::path& folder);

struct MadeSweep {
  SweepPlan plan;
  bool was_there = false;
};
/// Makes the folder of a sweep; one that holds this very sweep stays as it is. Throws InputError for what is wrong
/// with the input or a case of it, before anything is written, and OutputError for a folder that holds other results
/// or cannot be written.
MadeSweep make_sweep(const SweepInput& input, const std::filesystem::path& folder,
                     std::string_view version);

/// The plan as a table.
std::string plan_text(const std::vector<std::string>& keys, const SweepCases& cases);

/// Whether the input of a case is what the sweep made it; its comments do not count.
bool is_as_made(const SweepPlan& plan, const PlannedCase& of);

/// How a case has ended.
struct CaseEnd {
  int key = 0;  ///< its number
  int exit_code = 0;
  double seconds = 0;
  std::string reason;  ///< why it failed
};
/// Empty where it has not, or has lost its results since.
std::optional<CaseEnd> read_end(const SweepPlan& plan, int number);
void write_end(const SweepPlan& plan, const CaseEnd& end);

}  // namespace sbeh::studies
