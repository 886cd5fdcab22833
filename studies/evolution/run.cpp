#include "studies/evolution/run.h"

#include "studies/evolution/frame_file.h"
#include "studies/evolution/run_recorder.h"
#include "studies/io/csv.h"
#include "studies/io/errors.h"
#include "studies/io/output.h"
#include "studies/io/progress.h"
#include "studies/io/timed_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <sstream>

namespace sbeh::studies {

namespace fs = std::filesystem;
using surface3d::FlowRecord;
using surface3d::State;
using surface3d::StepView;

namespace {

// ---- what an earlier run left -------------------------------------------------------------------

// What makes a run: its description without the version, and without what changes no result.
std::string physics_of(const std::string& description) {
  std::istringstream text(description);
  std::string line, kept;
  std::getline(text, line);
  while (std::getline(text, line))
    if (!line.starts_with("checkpoint_minutes = ")) kept += line + "\n";
  return kept;
}
std::string first_line(const std::string& text) { return text.substr(0, text.find('\n')); }

// Whether a table that is to have rows at these times has those up to a time, and is not cut before.
bool reaches(const std::vector<TimedRow>& rows, const std::vector<double>& times, double until) {
  const double slack = surface3d::same_time * until;
  const auto after = std::upper_bound(times.begin(), times.end(), until + slack);
  return after == times.begin() || (!rows.empty() && rows.back().time >= *(after - 1) - slack);
}

// The newest state in the folder that can be read and whose rows are there: a frame or the checkpoint;
// empty when there is none yet. Throws OutputError when there are some and all are damaged.
std::optional<Frame> newest_frame(const RunInput& input, const OutputFolder& folder) {
  std::vector<fs::path> candidates{folder / checkpoint_name};
  const std::vector<TimedRow> series = timed_rows(folder / "series.csv", 0);
  const std::vector<TimedRow> frames = timed_rows(folder / "frames.csv", 1);
  for (std::size_t k = frames.size(); k-- > 0;)
    candidates.push_back(folder / split_csv(frames[k].line)[2]);
  std::optional<Frame> newest;
  bool damaged = false;
  for (const fs::path& path : candidates) {
    if (!fs::exists(path)) continue;
    try {
      Frame frame = read_frame(path);
      const double time = frame.record.time;
      const std::vector<double> rows =
          input.times.every_step ? std::vector{time} : input.times.rows;
      if (!reaches(series, rows, time) || !reaches(frames, input.times.states, time)) continue;
      if (!newest || frame.record.time > newest->record.time) newest = std::move(frame);
      if (path != candidates.front()) break;  // those before it are older
    } catch (const InputError& error) {
      damaged = true;
      tell(fmt::format("sbeh: {}; going back to the state before it\n", error.what()));
    }
  }
  if (damaged && !newest)  // starting anew would overwrite what somebody may still mend
    throw OutputError(fmt::format(
        "{}: none of its frames can be read; choose another folder with -o, or delete its run.toml "
        "and series.csv to start anew",
        folder.path().string()));
  return newest;
}

// The frame to go on from, empty for a run from the start. Throws OutputError when the folder holds
// what must not be overwritten.
std::optional<Frame> frame_to_resume(const RunInput& input, const OutputFolder& folder,
                                     const std::string& description, bool resume) {
  const std::string where = folder.path().string();
  if (fs::exists(folder / "scan.csv"))
    throw OutputError(
        fmt::format("{}: already holds a scan; choose another folder with -o", where));
  if (fs::exists(folder / "series.csv") && !fs::exists(folder / "run.toml"))
    throw OutputError(
        fmt::format("{}: already holds a run, but without its run.toml; choose another folder with "
                    "-o",
                    where));
  if (!fs::exists(folder / "run.toml")) return {};
  if (!resume)
    throw OutputError(
        fmt::format("{}: already holds a run (see its run.toml), which is not overwritten; go on "
                    "with it by --resume, or choose another folder with -o",
                    where));
  const std::string before = read_file(folder / "run.toml");
  if (physics_of(before) != physics_of(description))
    throw OutputError(
        fmt::format("{}: holds a run with other parameters (compare its run.toml); choose another "
                    "folder with -o",
                    where));
  if (first_line(before) != first_line(description))
    throw OutputError(fmt::format(
        "{}: holds a run of another version of sbeh (see the first line of its run.toml), whose "
        "frames may go on differently; to start from one of them all the same, use shape = "
        "\"frame\" and another folder",
        where));
  return newest_frame(input, folder);
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
  const RunStart start = frame ? RunStart{frame->mesh, frame->beta, frame->target} : *begin;
  write_file(folder / "run.toml", description);

  const auto mesh = std::make_shared<const surface3d::Triangulation>(start.mesh);
  surface3d::FlowStart from{.state = {start.mesh.nodes, start.beta}};
  if (frame) {
    from.record = frame->record;
    from.memory = frame->memory;
  }
  RunRecorder recorder(input, start.target, mesh, folder,
                       frame ? std::optional(from.record.time) : std::optional<double>());
  surface3d::FlowSchedule schedule = schedule_of(input.times);
  const auto over = from.record.ends;
  if (over) schedule.end_time = from.record.time;
  try {
    surface3d::FlowResult run = surface3d::run_flow(
        mesh, input.material, input.model, from, start.target, input.numerics, schedule,
        [&](const FlowRecord& record, const State& state, const StepView& view, bool exact) {
          return recorder(record, state, view, exact);
        });
    if (over) run.stop = *over;
    recorder.finish(run);
    return {run, recorder.frames(), from.record.time, recorder.unresolved_from()};
  } catch (const OutputError& error) {
    throw OutputError(
        fmt::format("{}; once that is mended, the same command goes on from the newest frame (sbeh "
                    "run with --resume)",
                    error.what()));
  }
}

}  // namespace sbeh::studies
