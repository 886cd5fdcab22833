#include "studies/evolution/run.h"

#include "studies/evolution/checkpoint.h"
#include "studies/evolution/event_log.h"
#include "studies/evolution/evolution_files.h"
#include "studies/evolution/flow_progress.h"
#include "studies/evolution/resume.h"
#include "studies/evolution/run_start.h"
#include "studies/io/description.h"
#include "studies/io/interrupt.h"
#include "surface3d/shared_flow.h"
#include "surface3d/stationary/rest_ahead.h"
#include "surface3d/symmetry.h"

#include <algorithm>
#include <utility>

namespace sbeh::studies {

namespace fs = std::filesystem;
using surface3d::FlowRecord;
using surface3d::FlowStop;
using surface3d::StepView;

namespace {

// What a run leaves in its folder while it goes on: all its observers.
class RunObservers {
 public:
  // Of a run that begins, or goes on, at `start`. Of the files of an earlier run what is not later than
  // `until` stays. Throws OutputError.
  RunObservers(const RunInput& input, const OutputFolder& folder, FlowMoment start, double until);

  // Lets each of them see the step. False when a signal asks for the end; the checkpoint is written then.
  // Throws OutputError.
  bool see(const FlowRecord& record, const surface3d::State& state, const StepView& view,
           bool exact);
  // The last state: a row and a frame. A run that is to go on later has left its checkpoint.
  void finish(const surface3d::FlowResult& run);

  const std::vector<FrameEntry>& frames() const { return frames_.entries(); }
  const std::optional<double>& unresolved_from() const { return events_.unresolved_from(); }

 private:
  surface3d::Diagnostics diagnostics();

  const RunInput& input_;
  FlowMoment now_;
  std::shared_ptr<const surface3d::Triangulation> symmetric_mesh_;  // that has the one below
  std::optional<meshing::MeshSymmetry> mesh_symmetry_;
  ProgressLine line_;
  LongProgress progress_;
  SeriesWriter series_;
  StateFiles frames_;
  EventLog events_;
  Checkpoint checkpoint_;
};

RunObservers::RunObservers(const RunInput& input, const OutputFolder& folder, FlowMoment start,
                           double until)
    : input_(input),
      now_(std::move(start)),
      progress_(line_, input.times.end),
      series_(folder, input.times, until),
      frames_(folder, "frames", ".vtu", input.times.states, until),
      events_(folder, input.numerics.remesh, until, line_),
      checkpoint_(folder, input, line_) {}

surface3d::Diagnostics RunObservers::diagnostics() {
  surface3d::Diagnostics d = surface3d::diagnose(*now_.mesh, input_.material, now_.state);
  if (input_.symmetry.mesh.is_trivial()) return d;
  if (symmetric_mesh_ != now_.mesh) {
    const auto& [of_first_triangles, kept] = input_.symmetry;
    mesh_symmetry_ = surface3d::symmetry_of(*now_.mesh, now_.state, of_first_triangles);
    if (!mesh_symmetry_ && !kept.is_trivial())  // new triangles have no more than that
      mesh_symmetry_ = surface3d::symmetry_of(*now_.mesh, now_.state, kept);
    symmetric_mesh_ = now_.mesh;
  }
  if (mesh_symmetry_) d.asymmetry = surface3d::asymmetry(*now_.mesh, now_.state, *mesh_symmetry_);
  return d;
}

bool RunObservers::see(const FlowRecord& record, const surface3d::State& state,
                       const StepView& view, bool exact) {
  progress_.see(record);
  events_.see(record, view);
  now_ = {view.mesh, state, now_.target, record, view.memory, view.fields, now_.symmetry};
  if (record.ends) return true;  // what remains is for finish()
  series_.see(record, exact, [&] { return diagnostics(); });
  const auto write = [&](const fs::path& file) { write_frame(file, now_, input_); };
  if (frames_.see(record.time, exact, write)) checkpoint_.put_off();
  if (interrupt_signal() == 0) return checkpoint_.see(now_), true;
  checkpoint_.write(now_);
  return false;
}

void RunObservers::finish(const surface3d::FlowResult& run) {
  line_.end();
  if (run.stop == surface3d::FlowStop::interrupted) return;
  now_.record = run.last;
  series_.finish(run.last, [&] { return diagnostics(); });
  frames_.finish(run.last.time, [&](const fs::path& file) { write_frame(file, now_, input_); });
  checkpoint_.remove();
}

surface3d::FlowResult run_observed(const RunInput& input, const FlowMoment& start,
                                   RunObservers& observers) {
  model::FlowSchedule schedule = schedule_of(input.times);
  const auto over = start.record.ends;
  if (over) schedule.end_time = start.record.time;
  surface3d::RestWatch rest(input.material, input.model, start.target, start.record);
  bool is_near = false;
  surface3d::FlowResult run = surface3d::run_shared_flow(
      input.material, input.model, start, input.numerics, schedule,
      [&](const FlowRecord& seen, const surface3d::State& state, const StepView& view, bool exact) {
        FlowRecord record = seen;
        is_near =
            input.finish == RunFinish::newton && !seen.ends && rest.near(seen, *view.mesh, state);
        if (is_near) record.ends = FlowStop::near_rest;
        return observers.see(record, state, view, exact) && !is_near;
      },
      surface3d::Ranks::all());
  if (is_near) run.last.ends = run.stop = FlowStop::near_rest;
  if (over) run.stop = *over;
  return run;
}

}  // namespace

RunSummary run_surface(const RunInput& asked, const fs::path& path, std::string_view version,
                       bool resumed) {
  std::optional<RunStart> begin;  // before the folder: a start that cannot be made leaves none
  if (!fs::exists(path / "run.toml")) {
    if (resumed) require_run(path);
    begin = start_of(asked);
  }
  const OutputFolder folder(path);
  require_no_other_results(folder, resumed);
  const Resumption known = resumed ? resume(asked, folder, version) : Resumption{.input = asked};
  const RunInput& input = known.input;
  if (!known.moment && !begin) begin = start_of(input);
  write_file(folder / "run.toml",
             with_remarks(describe(input, version), begin ? begin->remarks : known.remarks));
  if (begin)
    for (const std::string& remark : begin->remarks) tell(fmt::format("sbeh: {}\n", remark));

  FlowMoment start = known.moment ? *known.moment : begin->moment;
  start.symmetry = input.symmetry;
  RunObservers observers(input, folder, start, known.moment ? start.record.time : -1);
  try {
    const surface3d::FlowResult run = run_observed(input, start, observers);
    observers.finish(run);
    const std::vector<FrameEntry>& frames = observers.frames();
    return {run, int(frames.size()), frames.empty() ? "" : frames.back().file, start.record.time,
            observers.unresolved_from()};
  } catch (const OutputError& error) {
    throw OutputError(
        fmt::format("{}; once that is mended, the same command goes on from the newest frame (sbeh "
                    "run with --resume)",
                    error.what()));
  }
}

}  // namespace sbeh::studies
