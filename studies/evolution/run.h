// One 3D run with its files.
#pragma once

#include "studies/evolution/run_input.h"
#include "surface3d/flow.h"

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace sbeh::studies {

struct RunSummary {
  surface3d::FlowResult run;
  int frames;                             ///< in the folder
  std::string last_frame;                 ///< relative to it
  double resumed_from;                    ///< time, 0 for a run from the start
  std::optional<double> unresolved_from;  ///< time from which the mesh was too coarse, if it was
};

/// Runs and leaves in the folder: run.toml (the input, resolved), series.csv (a row per output time),
/// frames/*.vtu (each the whole state), frames.csv (index,time,file), run.pvd for ParaView, and events.csv
/// (new meshes; the time from which the mesh was too coarse). Progress on
/// standard error. Every checkpoint_minutes, and at an interruption, the state is written to
/// checkpoint.vtu, which is gone when the run has ended by itself. With `resume` a run that was
/// interrupted or killed goes on from the newest of its frames and checkpoint.vtu and leaves the same
/// bits as one that was not; its start is not needed any more. One that has reached its end may be
/// lengthened (resume.h): then too the folder holds what its run.toml, run from the start, leaves.
/// Without it a folder that holds a run is refused.
/// Throws InputError and OutputError.
RunSummary run_surface(const RunInput& input, const std::filesystem::path& path,
                       std::string_view version, bool resume);

}  // namespace sbeh::studies
