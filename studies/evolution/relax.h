// One axisymmetric evolution, from an input to a folder of results.
#pragma once

#include "axisym/flow.h"
#include "studies/evolution/relax_input.h"

#include <filesystem>
#include <string_view>

namespace sbeh::studies {

/// The state and the area and volume that the input asks to start from, and the material (of a scan's
/// row: its L). Throws OutputError or std::invalid_argument when the start cannot be made.
struct RelaxStart {
  axisym::State state;
  axisym::Target target;
  model::Material material;
};
RelaxStart start_of(const RelaxInput& input);

struct RelaxSummary {
  axisym::FlowResult run;
  int profiles = 0;
};

/// Runs into a folder: run.toml, series.csv (a line per output time as it is reached), profiles/ and
/// profiles.csv. A folder that already holds a run is refused. Throws OutputError.
RelaxSummary run_relax(const RelaxInput& input, const std::filesystem::path& folder,
                       std::string_view version);

}  // namespace sbeh::studies
