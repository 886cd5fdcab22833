#include "studies/evolution/resume.h"

#include "studies/evolution/checkpoint.h"
#include "studies/evolution/evolution_files.h"
#include "studies/io/description.h"
#include "studies/parameters/input_kind.h"

#include <fmt/format.h>

#include <algorithm>

namespace sbeh::studies {

namespace fs = std::filesystem;
using model::FlowStop;

namespace {

// ---- the newest state ---------------------------------------------------------------------------

struct Kept {
  FlowMoment moment;
  fs::path file;
};

// Whether a table that is to have rows at these times has those up to a time, and is not cut before.
bool reaches(const std::vector<TimedLine>& rows, const std::vector<double>& times, double until) {
  const double slack = model::same_time * until;
  const auto after = std::upper_bound(times.begin(), times.end(), until + slack);
  return after == times.begin() || (!rows.empty() && rows.back().time >= *(after - 1) - slack);
}

// The newest state in the folder that can be read and whose rows are there: a frame or the checkpoint;
// empty when there is none yet. Throws OutputError when there are some and none can be gone on with.
std::optional<Kept> newest_state(const Times& times, const OutputFolder& folder) {
  std::vector<fs::path> candidates{folder / Checkpoint::file_name};
  const std::vector<TimedLine> series = timed_lines(folder / "series.csv"),
                               frames = timed_lines(folder / "frames.csv");
  for (const FrameEntry& frame : rows_of(frame_columns(), frames))
    candidates.insert(candidates.begin() + 1, folder / frame.file);  // the newest first
  std::optional<Kept> newest;
  bool damaged = false;
  for (const fs::path& path : candidates) {
    if (!fs::exists(path)) continue;
    try {
      FlowMoment frame = read_frame(path);
      const double time = frame.record.time;
      const std::vector<double> rows = times.every_step ? std::vector{time} : times.rows;
      if (!reaches(series, rows, time) || !reaches(frames, times.states, time)) continue;
      if (!newest || time > newest->moment.record.time) newest = Kept{std::move(frame), path};
      if (path != candidates.front()) break;  // those before it are older
    } catch (const InputError& error) {
      damaged = true;
      tell(fmt::format("sbeh: {}; going back to the state before it\n", error.what()));
    }
  }
  const bool there = fs::exists(folder / "frames/0001.vtu") || fs::exists(candidates.front());
  if (!newest && (damaged || there))  // starting anew would overwrite what may still be mended
    throw OutputError(
        fmt::format("{}: {}; choose another folder with -o, or delete its run.toml and series.csv "
                    "to start anew",
                    folder.path().string(),
                    damaged ? "none of its frames can be read"
                            : "no frame is there with its rows in series.csv and frames.csv"));
  return newest;
}

// ---- times --------------------------------------------------------------------------------------

bool is_later(double time, double than) { return time > than * (1 + model::same_time); }
std::vector<double> later(std::vector<double> times, double than) {
  std::erase_if(times, [&](double time) { return !is_later(time, than); });
  return times;
}

bool same_from(double t, const Times& a, const Times& b) {
  return a.end == b.end && a.exact_rows == b.exact_rows && later(a.rows, t) == later(b.rows, t)
      && later(a.states, t) == later(b.states, t);
}

// Those of before up to t, t itself, and those of after from there on.
std::vector<double> joined(std::vector<double> before, double t, const std::vector<double>& after) {
  std::erase_if(before, [&](double time) { return is_later(time, t); });
  if (!contains(before, t)) before.push_back(t);
  const std::vector<double> rest = later(after, t);
  before.insert(before.end(), rest.begin(), rest.end());
  return before;
}

// The times that were not asked for while it was time.
void tell_missed(const fs::path& folder, const Times& before, const Times& asked, double t) {
  const auto missed = [&](const std::vector<double>& there, const std::vector<double>& here) {
    return std::ranges::count_if(
        here, [&](double time) { return !is_later(time, t) && !contains(there, time); });
  };
  const auto rows = asked.exact_rows
                      ? missed(before.exact_rows ? before.rows : std::vector<double>{}, asked.rows)
                      : 0,
             frames = missed(before.states, asked.states);
  if (rows + frames > 0)
    tell(
        fmt::format("sbeh: {}: has gone to t = {:.6g} without {} of the times that output asks "
                    "for now, and {} of frames\n",
                    folder.string(), t, rows, frames));
}

[[noreturn]] void refuse_times(const fs::path& folder, const Times& before, const Times& asked,
                               double t) {
  if (asked.end < before.end)
    throw OutputError(
        fmt::format("{}: holds a run with other parameters: time.end: {} there, {} "
                    "here; a run may be lengthened, but not be shortened",
                    folder.string(), before.end, asked.end));
  throw OutputError(fmt::format(
      "{0}: holds a run with other times (end, output or frames in [time]) that is at t "
      "= {1:.6g} and not at its end, {2:.6g}; let it get there (sbeh run {0}/run.toml -o "
      "{0} --resume), then lengthen it",
      folder.string(), t, before.end));
}

// Of a run that is at the moment of `record`, with times of before, and is asked for others.
Times times_of(const fs::path& folder, const surface3d::FlowRecord& record, const Times& before,
               const Times& asked) {
  const double t = record.time;
  if (same_from(t, before, asked)) return before;
  const bool at_end = !is_later(before.end, t);
  if (asked.end < before.end) refuse_times(folder, before, asked, t);
  if (record.ends && record.ends != FlowStop::end_time) {
    tell(fmt::format("sbeh: {}: {} at t = {:.6g}, before its end: later times change nothing\n",
                     folder.string(), model::describe(*record.ends), t));
    return before;
  }
  if (!at_end) refuse_times(folder, before, asked, t);
  tell(fmt::format("sbeh: {}: its end was t = {:.6g}, it goes on to {:.6g}\n", folder.string(), t,
                   asked.end));
  Times times = asked;
  times.rows = joined(before.rows, t, asked.rows);
  times.states = joined(before.states, t, asked.states);
  return times;
}

void require_same_run(const OutputFolder& folder, const std::string& before,
                      const std::string& description) {
  const std::string other =
      mismatch(before, description, "a run",
               {"time.end", "time.output", "time.frames", "time.checkpoint_minutes"});
  if (!other.empty())
    throw OutputError(fmt::format(
        "{}: {}; choose another folder with -o; a run there may start from a frame of this one "
        "(shape = \"frame\")",
        folder.path().string(), other));
}

}  // namespace

void require_run(const fs::path& folder) {
  for (const char* file : {"run.toml", "series.csv", "scan.csv"})
    if (fs::exists(folder / file)) return;
  throw OutputError(fmt::format(
      "{}: there is nothing to resume; without --resume a run begins there", folder.string()));
}

void require_no_other_results(const OutputFolder& folder, bool resume) {
  const bool described = fs::exists(folder / "run.toml");
  if (fs::exists(folder / "scan.csv")) refuse(folder, "already holds a scan");
  if (fs::exists(folder / "series.csv") && !described)
    refuse(folder, "already holds a run, but without its run.toml");
  if (described && kind_of(folder / "run.toml") != InputKind::run)
    refuse(folder, "already holds other results than a run (see its run.toml)");
  if (described && !resume)
    throw OutputError(
        fmt::format("{}: already holds a run (see its run.toml), which is not overwritten; go on "
                    "with it by --resume, or choose another folder with -o",
                    folder.path().string()));
}

Resumption resume(const RunInput& input, const OutputFolder& folder, std::string_view version) {
  const std::string before = read_file(folder / "run.toml");
  require_same_run(folder, before, describe(input, version));
  Resumption resumed{.input = input, .remarks = remarks_in(before)};
  const Times times = read_run(folder / "run.toml").times;
  auto newest = newest_state(times, folder);
  if (!newest) {
    tell(fmt::format("sbeh: {}: no state is there yet: the run begins\n", folder.path().string()));
    return resumed;
  }
  surface3d::FlowRecord& record = newest->moment.record;
  resumed.input.times = times_of(folder.path(), record, times, input.times);
  tell_missed(folder.path(), times, input.times, record.time);
  if (record.ends == FlowStop::end_time && is_later(resumed.input.times.end, record.time)) {
    record.ends.reset();  // as in the frame of a run for which it is not the last
    write_frame(newest->file, newest->moment, input);
  }
  resumed.moment = std::move(newest->moment);
  return resumed;
}

}  // namespace sbeh::studies
