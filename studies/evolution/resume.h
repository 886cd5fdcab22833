// How a run in a folder is gone on with: from which state, and with which times where it is lengthened.
#pragma once

#include "studies/evolution/frame_file.h"
#include "studies/evolution/run_input.h"
#include "studies/io/output.h"

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace sbeh::studies {

/// Throws OutputError where there is no run to be resumed.
void require_run(const std::filesystem::path& folder);

/// Throws OutputError when the folder holds what must not be overwritten.
void require_no_other_results(const OutputFolder& folder, bool resume);

struct Resumption {
  RunInput input;  ///< what goes on: run from its start, it leaves the same bits
  std::optional<FlowMoment> moment =
      {};  ///< the newest state; empty where the run has left none yet
  std::vector<std::string> remarks = {};  ///< of its start
};

/// The run of the folder, as the input asks to go on with it. A run that has reached its end may be asked to go
/// further, with other rows and frames from there on; its former end remains one of both. Tells what of that
/// comes too late. Throws OutputError when the input asks for another run, for other times of one that has
/// not reached its end, or is none of this version, and when there are frames of which none can be read.
Resumption resume(const RunInput& input, const OutputFolder& folder, std::string_view version);

}  // namespace sbeh::studies
