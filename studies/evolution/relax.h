// One axisymmetric evolution, from an input to a folder of results.
#pragma once

#include "axisym/flow.h"
#include "studies/evolution/relax_input.h"

namespace sbeh::studies {

struct RelaxStart {
  axisym::State state;
  std::vector<std::string> remarks;  ///< what is not as it was where the start comes from
};

/// The state that the input asks to start from. Throws OutputError or std::invalid_argument when it cannot
/// be made.
RelaxStart start_of(const RelaxInput& input);

/// Of one core of 2026, as measured.
double seconds_per_step(const RelaxInput& input);

struct RelaxSummary {
  axisym::FlowResult run;
  int profiles = 0;
};

/// Runs into a folder: run.toml, series.csv (a line per output time as it is reached), profiles/ and
/// profiles.csv. A folder that already holds a run is refused, but not one with nothing but the run.toml of this
/// very run. Throws OutputError.
RelaxSummary run_relax(const RelaxInput& input, const std::filesystem::path& folder,
                       std::string_view version);

}  // namespace sbeh::studies
