#include "studies/evolution/checkpoint.h"

#include <fmt/format.h>

namespace sbeh::studies {

Checkpoint::Checkpoint(const OutputFolder& folder, const RunInput& input, ProgressLine& line)
    : file_(folder / file_name), input_(input), line_(line) {}

void Checkpoint::see(const FlowMoment& moment) {
  if (since_kept_.seconds() / 60 < input_.checkpoint_minutes) return;
  try {
    write(moment);
  } catch (const OutputError& error) {
    line_.say(fmt::format("sbeh: {}; the run goes on without this checkpoint", error.what()));
  }
  put_off();
}

}  // namespace sbeh::studies
