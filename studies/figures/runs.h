// The 3D runs in the folder of the figures: which are there, and completing one.
#pragma once

#include "studies/evolution/run.h"
#include "studies/figures/plan.h"

namespace sbeh::studies::figures {

/// A run that is there, be it made here or put there.
struct FoundRun {
  std::filesystem::path folder;
  RunInput input;                         ///< of its own run.toml
  bool ended;                             ///< by itself: it will not go on
  std::string ending;                     ///< such as "at rest at t = 3.2", or how far it is
  std::optional<double> unresolved_from;  ///< time from which its mesh was too coarse, if it was
};

/// The run at a planned place; empty where there is none. It may differ from the plan in its times, its
/// numerics and, unless `triangles` asks for a number, in its mesh. Throws OutputError when it is another
/// case (model, start, material), naming what differs, or when it is damaged.
std::optional<FoundRun> find_run(const std::filesystem::path& folder, const PlannedRun& plan,
                                 std::optional<int> triangles);

/// Its folder, with how far it is where it is there.
std::string missing_run(const PlannedRun& plan, const std::optional<FoundRun>& found);

/// The surface of a frame with its order, be the run that it belongs to of an older version too.
struct Snapshot {
  meshing::CurvedMesh mesh;  ///< order 3
  surface3d::Field beta;     // nodes
};
/// Throws InputError.
Snapshot read_snapshot(const std::filesystem::path& frame);

/// Makes the run, or goes on with what is found there, as that asks for; tells what it does. The time it
/// takes is added to run_times.csv. Throws InputError and OutputError.
RunSummary complete_run(const std::filesystem::path& folder, const PlannedRun& plan,
                        const std::optional<FoundRun>& found, std::string_view version);

/// Seconds that the run has taken in all; empty when it was put there.
std::optional<double> seconds_of(const std::filesystem::path& folder, const PlannedRun& plan);

}  // namespace sbeh::studies::figures
