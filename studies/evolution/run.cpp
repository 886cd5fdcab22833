#include "studies/evolution/run.h"

#include "studies/evolution/run_observers.h"
#include "studies/evolution/run_resume.h"
#include "studies/io/errors.h"

#include <fmt/format.h>

#include <memory>

namespace sbeh::studies {

namespace fs = std::filesystem;
using surface3d::FlowRecord;
using surface3d::State;
using surface3d::StepView;

namespace {

// Where the run begins, or goes on.
Moment moment_of(const std::optional<Frame>& frame, const std::optional<RunStart>& start) {
  const meshing::CurvedMesh& mesh = frame ? frame->mesh : start->mesh;
  Moment moment{.record = frame ? frame->record : FlowRecord{},
                .state = {mesh.nodes, frame ? frame->beta : start->beta},
                .mesh = std::make_shared<const surface3d::Triangulation>(mesh),
                .target = frame ? frame->target : start->target,
                .fields = {},
                .memory = {}};
  if (frame) moment.memory = frame->memory;
  return moment;
}

surface3d::FlowResult run_observed(const RunInput& input, const Moment& start,
                                   RunObservers& observers) {
  model::FlowSchedule schedule = schedule_of(input.times);
  const auto over = start.record.ends;
  if (over) schedule.end_time = start.record.time;
  surface3d::FlowResult run = surface3d::run_flow(
      start.mesh, input.material, input.model, {start.state, start.record, start.memory},
      start.target, input.numerics, schedule,
      [&](const FlowRecord& record, const State& state, const StepView& view, bool exact) {
        return observers.see(record, state, view, exact);
      });
  if (over) run.stop = *over;
  return run;
}

}  // namespace

RunSummary run_surface(const RunInput& input, const fs::path& path, std::string_view version,
                       bool resume) {
  std::optional<RunStart> begin;  // before the folder: a start that cannot be made leaves none
  if (!fs::exists(path / "run.toml")) begin = start_of(input);
  const OutputFolder folder(path);
  const std::string description = describe(input, version);
  const std::optional<Frame> frame = frame_to_resume(input, folder, description, resume);
  if (!frame && !begin) begin = start_of(input);
  write_file(folder / "run.toml", description);

  const Moment start = moment_of(frame, begin);
  RunObservers observers(input, folder, start, frame ? start.record.time : -1);
  try {
    const surface3d::FlowResult run = run_observed(input, start, observers);
    observers.finish(run);
    return {run, observers.frames(), start.record.time, observers.unresolved_from()};
  } catch (const OutputError& error) {
    throw OutputError(
        fmt::format("{}; once that is mended, the same command goes on from the newest frame (sbeh "
                    "run with --resume)",
                    error.what()));
  }
}

}  // namespace sbeh::studies
