#include "studies/evolution/checkpoint.h"

#include "studies/evolution/evolution_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>
#include <vector>

namespace sbeh::studies {

namespace fs = std::filesystem;

namespace {

constexpr const char* checkpoint_name = "checkpoint.vtu";

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
bool reaches(const std::vector<TimedLine>& rows, const std::vector<double>& times, double until) {
  const double slack = model::same_time * until;
  const auto after = std::upper_bound(times.begin(), times.end(), until + slack);
  return after == times.begin() || (!rows.empty() && rows.back().time >= *(after - 1) - slack);
}

// The newest state in the folder that can be read and whose rows are there: a frame or the checkpoint;
// empty when there is none yet. Throws OutputError when there are some and all are damaged.
std::optional<FlowMoment> newest_frame(const RunInput& input, const OutputFolder& folder) {
  std::vector<fs::path> candidates{folder / checkpoint_name};
  const std::vector<TimedLine> series = timed_lines(folder / "series.csv"),
                               frames = timed_lines(folder / "frames.csv");
  for (const FrameEntry& frame : rows_of(frame_columns(), frames))
    candidates.insert(candidates.begin() + 1, folder / frame.file);  // the newest first
  std::optional<FlowMoment> newest;
  bool damaged = false;
  for (const fs::path& path : candidates) {
    if (!fs::exists(path)) continue;
    try {
      FlowMoment frame = read_frame(path);
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

// Throws OutputError when the run in the folder is another one.
void require_same_run(const OutputFolder& folder, const std::string& description) {
  const std::string before = read_file(folder / "run.toml");
  if (physics_of(before) != physics_of(description))
    refuse(folder, "holds a run with other parameters (compare its run.toml)");
  if (first_line(before) != first_line(description))
    throw OutputError(fmt::format(
        "{}: holds a run of another version of sbeh (see the first line of its run.toml), whose "
        "frames may go on differently; to start from one of them all the same, use shape = "
        "\"frame\" and another folder",
        folder.path().string()));
}

}  // namespace

Checkpoint::Checkpoint(const OutputFolder& folder, double minutes, ProgressLine& line)
    : file_(folder / checkpoint_name), minutes_(minutes), line_(line) {}

void Checkpoint::see(const FlowMoment& moment) {
  if (since_kept_.seconds() / 60 < minutes_) return;
  try {
    write(moment);
  } catch (const OutputError& error) {
    line_.say(fmt::format("sbeh: {}; the run goes on without this checkpoint", error.what()));
  }
  put_off();
}

std::optional<FlowMoment> moment_to_resume(const RunInput& input, const OutputFolder& folder,
                                           const std::string& description, bool resume) {
  const bool described = fs::exists(folder / "run.toml");
  if (fs::exists(folder / "scan.csv")) refuse(folder, "already holds a scan");
  if (fs::exists(folder / "series.csv") && !described)
    refuse(folder, "already holds a run, but without its run.toml");
  if (!described) return {};
  if (!resume)
    throw OutputError(
        fmt::format("{}: already holds a run (see its run.toml), which is not overwritten; go on "
                    "with it by --resume, or choose another folder with -o",
                    folder.path().string()));
  require_same_run(folder, description);
  return newest_frame(input, folder);
}

}  // namespace sbeh::studies
