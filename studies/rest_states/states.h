// Rest states in 3D by Newton's method: what each is, in which directions its energy falls, its lowest modes.
#pragma once

#include "studies/rest_states/pass_row.h"
#include "studies/rest_states/rest_row.h"

#include <filesystem>
#include <string_view>
#include <vector>

namespace sbeh::studies {

struct StatesSummary {
  std::vector<RestRow> rows;
  std::vector<PassRow> passes{};
  int computed = 0;  ///< the others were there
  double seconds = 0;
  bool interrupted = false;
};

/// Computes the rows that are not there yet into a folder: run.toml (the resolved input), states.csv, frames/ (a state each, from which
/// `sbeh run` goes on) and modes/ (a .vtu of each eigenpair), and with `passes` passes.csv. A folder that holds other results is refused. Throws InputError, OutputError.
StatesSummary run_states(const StatesInput& input, const std::filesystem::path& folder,
                         std::string_view version);

}  // namespace sbeh::studies
