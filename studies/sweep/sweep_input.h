// What a sweep is asked for: an input of another command, and values that take turns in it.
#pragma once

#include "studies/io/toml_reader.h"
#include "studies/parameters/input_kind.h"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace sbeh::studies {

/// Keys such as "material.L" whose values go together. Values are as they stand in files.
struct SweepAxis {
  std::vector<std::string> keys;
  std::vector<std::vector<std::string>> steps;  ///< of each a value for each key
};

/// A table [sweep]: `base`, another file, unless the input stands beside it in the same one; [sweep.grid], lists of
/// values of which all combinations are taken; [[sweep.together]], lists of equal length whose values go together;
/// [sweep.random], `samples` random values by a `seed`.
struct SweepInput {
  std::filesystem::path file, base;  ///< of the sweep and of the input; the same, or not
  std::vector<SweepAxis> axes;       ///< all combinations, the last axis fastest
};

inline constexpr std::size_t most_cases = 9999;

/// Throws InputError.
SweepInput read_sweep(const std::filesystem::path& path);

std::vector<std::string> swept_keys(const SweepInput& input);
std::size_t case_count(const SweepInput& input);

/// What a case costs, about.
struct CaseCost {
  double seconds = 0;    ///< of one core of 2026
  double megabytes = 0;  ///< of memory
  int cores = 1;         ///< with which it should take an hour at most, up to 4
};

/// One case, 1 … .
struct SweepCase {
  int number = 0;
  std::vector<std::string> values;  ///< of swept_keys
  std::string description;          ///< the whole input, as its command describes it
  CaseCost cost;
};

/// A whole sweep.
struct SweepCases {
  InputKind kind = InputKind::run;  ///< run, relax, scan or states
  std::vector<SweepCase> cases;
};
/// Reads every case by the reader of its command. Throws InputError for the first that is wrong, and says which it is.
SweepCases cases_of(const SweepInput& input, std::string_view version);

}  // namespace sbeh::studies
