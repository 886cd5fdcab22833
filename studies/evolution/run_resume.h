// What an earlier run left in a folder, to go on from.
#pragma once

#include "studies/evolution/frame_file.h"
#include "studies/evolution/run_input.h"
#include "studies/io/output.h"

#include <optional>
#include <string>

namespace sbeh::studies {

/// The newest state of the run in the folder, which has this description; empty for a run from the start.
/// Throws OutputError when the folder holds what must not be overwritten.
std::optional<Frame> frame_to_resume(const RunInput& input, const OutputFolder& folder,
                                     const std::string& description, bool resume);

}  // namespace sbeh::studies
