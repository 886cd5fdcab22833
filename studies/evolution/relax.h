// One axisymmetric evolution, from an input to a folder of results.
#pragma once

#include "studies/evolution/relax_start.h"

#include <filesystem>
#include <string_view>

namespace sbeh::studies {

struct RelaxSummary {
  axisym::FlowResult run;
  int profiles = 0;
};

/// Runs into a folder: run.toml, series.csv (a line per output time as it is reached), profiles/ and
/// profiles.csv. A folder that already holds a run is refused. Throws OutputError.
RelaxSummary run_relax(const RelaxInput& input, const std::filesystem::path& folder,
                       std::string_view version);

}  // namespace sbeh::studies
