#include "studies/run.h"

#include "studies/csv_line.h"
#include "studies/describe.h"
#include "studies/frame_file.h"
#include "studies/interrupt.h"
#include "studies/output.h"
#include "studies/progress.h"
#include "studies/series_file.h"
#include "studies/toml_reader.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <memory>
#include <optional>
#include <sstream>

namespace sbeh::studies {

namespace fs = std::filesystem;
using surface3d::FlowRecord;
using surface3d::FlowStop;
using surface3d::State;
using surface3d::StepView;

namespace {

constexpr const char* frame_header = "index,time,file";
constexpr const char* checkpoint_name = "checkpoint.vtu";

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

// The rows of a table with their time, up to the first that is cut off.
struct TimedRow {
  double time;
  std::string line;
};
std::vector<TimedRow> rows_of(const fs::path& path, std::size_t time_column) {
  std::vector<TimedRow> rows;
  if (!fs::exists(path)) return rows;
  std::istringstream text(read_file(path));
  std::string line, header;
  std::getline(text, header);
  const std::size_t columns = split_csv(header).size();
  while (std::getline(text, line)) {
    const auto fields = split_csv(line);
    double time = 0;
    if (fields.size() != columns || text.eof() || !parse_number(fields[time_column], time)) break;
    rows.push_back({time, line});
  }
  return rows;
}

// Writes a table anew with the rows up to a time.
void keep_until(const fs::path& path, const std::string& header, const std::vector<TimedRow>& rows,
                double time) {
  std::string text = header + "\n";
  for (const TimedRow& row : rows)
    if (row.time <= time) text += row.line + "\n";
  write_file(path, text);
}

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
  const std::vector<TimedRow> series = rows_of(folder / "series.csv", 0);
  const std::vector<TimedRow> frames = rows_of(folder / "frames.csv", 1);
  for (auto row = frames.rbegin(); row != frames.rend(); ++row)
    candidates.push_back(folder / split_csv(row->line)[2]);
  std::optional<Frame> newest;
  bool damaged = false;
  for (const fs::path& path : candidates) {
    if (!fs::exists(path)) continue;
    try {
      Frame frame = read_frame(path);
      const double time = frame.record.time;
      if (!reaches(series, input.output_times, time) || !reaches(frames, input.frame_times, time))
        continue;
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

// Why a run ends with a state, if it does; the same as model::Flow says after that step.
std::optional<FlowStop> end_of_run(const RunInput& input, const surface3d::Triangulation& mesh,
                                   const FlowRecord& record, const State& state) {
  if (record.time == 0) return {};
  if (!(surface3d::mesh_quality(mesh, state.X) > surface3d::degenerate_quality))
    return FlowStop::unresolved;
  if (input.stop_at_rest
      && std::max(record.normal_speed, record.order_speed) < input.numerics.rest_speed)
    return FlowStop::at_rest;
  if (record.time >= input.end_time) return FlowStop::end_time;
  return {};
}

// ---- what this run leaves -----------------------------------------------------------------------

// Writes what the observer sees at the times asked for.
class Recorder {
 public:
  Recorder(const RunInput& input, const RunStart& start,
           std::shared_ptr<const surface3d::Triangulation> mesh, const OutputFolder& folder,
           std::optional<double> resumed_at)
      : input_(input),
        start_(start),
        mesh_(std::move(mesh)),
        folder_(folder),
        began_(std::chrono::steady_clock::now()),
        shown_(began_),
        kept_(began_) {
    make_folder(folder / "frames");
    const auto frames = rows_of(folder / "frames.csv", 1);
    const double until = resumed_at.value_or(-1);
    keep_until(folder / "series.csv", series_header(), rows_of(folder / "series.csv", 0), until);
    keep_until(folder / "frames.csv", frame_header, frames, until);
    for (const TimedRow& row : frames)
      if (row.time <= until) frames_.push_back({row.time, split_csv(row.line)[2]});
    if (!frames_.empty()) write_file(folder / "run.pvd", pvd_text(frames_));
    if (!frames_.empty()) last_frame_ = frames_.back().time;
    const auto series = rows_of(folder / "series.csv", 0);
    if (!series.empty()) last_row_ = series.back().time;
    series_ = std::make_unique<AppendFile>(folder / "series.csv");
    index_ = std::make_unique<AppendFile>(folder / "frames.csv");
  }

  bool operator()(const FlowRecord& record, const State& state, const StepView& view, bool exact) {
    ++steps_;
    show(record);
    last_fields_ = view.fields;
    last_memory_ = view.memory;
    if (end_of_run(input_, *mesh_, record, state)) return true;  // what remains is for finish()
    if (exact && contains(input_.output_times, record.time)) write_row(record, state);
    if (exact && contains(input_.frame_times, record.time)) write_state(record, state, view);
    if (interrupt_signal() == 0) return keep(record, state, view), true;
    write(folder_ / checkpoint_name, record, state, view);
    return false;
  }

  /// The last state: a row and a frame. A run that is to go on later has left its checkpoint.
  void finish(const surface3d::FlowResult& run) {
    if (terminal_ && steps_ > 1) tell("\n");
    if (run.stop == FlowStop::interrupted) return;
    if (run.last.time != last_row_) write_row(run.last, run.state);
    if (run.last.time != last_frame_)
      write_state(run.last, run.state, {last_fields_, last_memory_});
    remove_file(folder_ / checkpoint_name);
  }
  int frames() const { return int(frames_.size()); }

 private:
  static bool contains(const std::vector<double>& times, double time) {
    const double slack = surface3d::same_time * time;  // the same number reached by another sum
    const auto at = std::lower_bound(times.begin(), times.end(), time - slack);
    return at != times.end() && *at <= time + slack;
  }
  void write_row(const FlowRecord& record, const State& state) {
    series_->append(series_line(record, surface3d::diagnose(*mesh_, input_.material, state)));
    last_row_ = record.time;
  }
  void write(const fs::path& path, const FlowRecord& record, const State& state,
             const StepView& view) const {
    Frame frame{.mesh = start_.mesh,
                .beta = state.beta,
                .record = record,
                .target = start_.target,
                .memory = view.memory};
    frame.mesh.nodes = state.X;
    const auto curvature = surface3d::curvature_of(*mesh_, state.X);
    if (!curvature) throw std::runtime_error("the surface is degenerate");
    write_frame(path, frame, {curvature->H, curvature->node_normals, view.fields.V});
  }
  void write_state(const FlowRecord& record, const State& state, const StepView& view) {
    const std::string file = fmt::format("frames/{:04d}.vtu", frames_.size());
    write(folder_ / file, record, state, view);
    index_->append(fmt::format("{},{},{}", frames_.size(), record.time, file));
    frames_.push_back({record.time, file});
    write_file(folder_ / "run.pvd", pvd_text(frames_));
    last_frame_ = record.time;
    kept_ = std::chrono::steady_clock::now();
  }
  // From time to time. Where there is no room the run goes on: of its results nothing is missing.
  void keep(const FlowRecord& record, const State& state, const StepView& view) {
    using minutes = std::chrono::duration<double, std::ratio<60>>;
    if (minutes(std::chrono::steady_clock::now() - kept_).count() < input_.checkpoint_minutes)
      return;
    try {
      write(folder_ / checkpoint_name, record, state, view);
    } catch (const OutputError& error) {
      tell(fmt::format("{}sbeh: {}; the run goes on without this checkpoint\n",
                       terminal_ ? "\r\033[K" : "", error.what()));
    }
    kept_ = std::chrono::steady_clock::now();
  }
  // On a terminal one line that is rewritten, otherwise a line every minute.
  void show(const FlowRecord& record) {
    using std::chrono::duration, std::chrono::steady_clock;
    const auto now = steady_clock::now();
    if (now - shown_ < std::chrono::milliseconds(terminal_ ? 200 : 60'000)) return;
    shown_ = now;
    const double per_step = duration<double>(now - began_).count() / steps_;
    const double left = (input_.end_time - record.time) / record.next_step * per_step;
    tell(
        fmt::format("{}t = {:.4g} of {:.4g}, time step {:.2g}, energy {:.8g}, {:.2g} s a step, "
                    "at most {:.0f} s left{}",
                    terminal_ ? "\r\033[K" : "", record.time, input_.end_time, record.time_step,
                    record.energy.total(), per_step, left, terminal_ ? "" : "\n"));
  }

  const RunInput& input_;
  const RunStart& start_;
  std::shared_ptr<const surface3d::Triangulation> mesh_;
  const OutputFolder& folder_;
  std::unique_ptr<AppendFile> series_, index_;
  std::vector<FrameEntry> frames_;
  surface3d::StepFields last_fields_;
  surface3d::FlowMemory last_memory_;
  const bool terminal_ = isatty(STDERR_FILENO) != 0;
  std::chrono::steady_clock::time_point began_, shown_;
  std::chrono::steady_clock::time_point kept_;  // when the last frame or checkpoint was written
  int steps_ = 0;
  double last_row_ = -1, last_frame_ = -1;
};

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
  Recorder recorder(input, start, mesh, folder,
                    frame ? std::optional(from.record.time) : std::optional<double>());
  surface3d::FlowSchedule schedule{.end_time = input.end_time,
                                   .output_times = input.output_times,
                                   .stop_at_rest = input.stop_at_rest};
  schedule.output_times.insert(schedule.output_times.end(), input.frame_times.begin(),
                               input.frame_times.end());
  const auto over = frame ? end_of_run(input, *mesh, from.record, from.state) : std::nullopt;
  if (over) schedule.end_time = from.record.time;
  try {
    surface3d::FlowResult run = surface3d::run_flow(
        mesh, input.material, input.model, from, start.target, input.numerics, schedule,
        [&](const FlowRecord& record, const State& state, const StepView& view, bool exact) {
          return recorder(record, state, view, exact);
        });
    if (over) run.stop = *over;
    recorder.finish(run);
    return {run, recorder.frames(), from.record.time};
  } catch (const OutputError& error) {
    throw OutputError(fmt::format(
        "{}; once that is mended, the same command with --resume goes on from the newest frame",
        error.what()));
  }
}

}  // namespace sbeh::studies
