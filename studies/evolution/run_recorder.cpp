#include "studies/evolution/run_recorder.h"

#include "studies/evolution/series_file.h"
#include "studies/io/csv.h"
#include "studies/io/interrupt.h"
#include "studies/io/progress.h"
#include "studies/io/timed_table.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <stdexcept>

namespace sbeh::studies {

namespace fs = std::filesystem;
using std::chrono::steady_clock;
using surface3d::FlowRecord;
using surface3d::State;

namespace {

constexpr const char* frame_header = "index,time,file";
constexpr const char* event_header =
    "time,event,triangles,min_angle,mesh_quality,turn,curvature_gap,energy_change,area_change,"
    "volume_change,distance";

std::string event_line(double time, const char* event, int triangles,
                       const surface3d::Resolution& r, const surface3d::RemeshReport& report) {
  return fmt::format("{},{},{},{},{},{},{},{},{},{},{}", time, event, triangles, r.min_angle,
                     r.mesh_quality, r.curvature, r.curvature_gap, report.energy_change,
                     report.area_change, report.volume_change, report.distance);
}

// Which limits are passed.
std::string reasons(const surface3d::Resolution& r) {
  std::vector<std::string> words;
  const auto above = [&](const char* what, double value, double limit) {
    if (value > limit) words.push_back(fmt::format("{} {:.3g} > {}", what, value, limit));
  };
  above("|B| times the node spacing", r.curvature, surface3d::largest_turn);
  above("difference of the two curvatures", r.curvature_gap, surface3d::largest_curvature_gap);
  const auto below = [&](const char* what, double value, double limit) {
    if (value < limit) words.push_back(fmt::format("{} {:.3g} < {}", what, value, limit));
  };
  below("mesh quality", r.mesh_quality, surface3d::smallest_quality);
  below("smallest angle", r.min_angle, surface3d::smallest_angle);
  return fmt::format("{}", fmt::join(words, ", "));
}

}  // namespace

RunRecorder::RunRecorder(const RunInput& input, const surface3d::Target& target,
                         std::shared_ptr<const surface3d::Triangulation> mesh,
                         const OutputFolder& folder, std::optional<double> resumed_at)
    : input_(input),
      target_(target),
      mesh_(std::move(mesh)),
      folder_(folder),
      terminal_(isatty(STDERR_FILENO) != 0),
      began_(steady_clock::now()),
      shown_(began_),
      kept_(began_) {
  make_folder(folder / "frames");
  const auto frames = timed_rows(folder / "frames.csv", 1);
  const auto events = timed_rows(folder / "events.csv", 0);
  const double until = resumed_at.value_or(-1);
  keep_until(folder / "series.csv", header_of(series_columns()),
             timed_rows(folder / "series.csv", 0), until);
  keep_until(folder / "frames.csv", frame_header, frames, until);
  keep_until(folder / "events.csv", event_header, events, until);
  for (const TimedRow& row : frames)
    if (row.time <= until) frames_.push_back({row.time, split_csv(row.line)[2]});
  for (const TimedRow& row : events)
    if (row.time <= until && split_csv(row.line)[1] == "unresolved" && !unresolved_from_)
      unresolved_from_ = row.time;
  if (!frames_.empty()) write_file(folder / "run.pvd", pvd_text(frames_));
  if (!frames_.empty()) last_frame_ = frames_.back().time;
  const auto series = timed_rows(folder / "series.csv", 0);
  if (!series.empty()) last_row_ = series.back().time;
  series_ = std::make_unique<AppendFile>(folder / "series.csv");
  index_ = std::make_unique<AppendFile>(folder / "frames.csv");
  events_ = std::make_unique<AppendFile>(folder / "events.csv");
}

bool RunRecorder::operator()(const FlowRecord& record, const State& state,
                             const surface3d::StepView& view, bool exact) {
  ++steps_;
  show(record);
  note_events(record, view);
  mesh_ = view.mesh;
  last_ = {view.fields, view.memory};
  if (record.ends) return true;  // what remains is for finish()
  if (input_.times.every_step || (exact && contains(input_.times.rows, record.time)))
    write_row(record, state);
  if (exact && contains(input_.times.states, record.time)) write_frame_of(record, state);
  if (interrupt_signal() == 0) return keep(record, state), true;
  write(folder_ / checkpoint_name, record, state);
  return false;
}

void RunRecorder::finish(const surface3d::FlowResult& run) {
  if (terminal_ && steps_ > 1) tell("\n");
  if (run.stop == surface3d::FlowStop::interrupted) return;
  if (run.last.time != last_row_) write_row(run.last, run.state);
  if (run.last.time != last_frame_) write_frame_of(run.last, run.state);
  remove_file(folder_ / checkpoint_name);
}

void RunRecorder::write_row(const FlowRecord& record, const State& state) {
  series_->append(series_line(record, surface3d::diagnose(*mesh_, input_.material, state)));
  last_row_ = record.time;
}

void RunRecorder::write(const fs::path& path, const FlowRecord& record, const State& state) const {
  const auto curvature = surface3d::curvature_of(*mesh_, state.X);
  if (!curvature) throw std::runtime_error("the surface is degenerate");
  write_frame(path,
              {.mesh = {.order = 3, .triangles = mesh_->triangles, .nodes = state.X},
               .beta = state.beta,
               .record = record,
               .target = target_,
               .memory = last_.memory},
              {curvature->H, curvature->node_normals, last_.fields.V});
}

void RunRecorder::write_frame_of(const FlowRecord& record, const State& state) {
  const std::string file = fmt::format("frames/{:04d}.vtu", frames_.size());
  write(folder_ / file, record, state);
  index_->append(fmt::format("{},{},{}", frames_.size(), record.time, file));
  frames_.push_back({record.time, file});
  write_file(folder_ / "run.pvd", pvd_text(frames_));
  last_frame_ = record.time;
  kept_ = steady_clock::now();
}

// A mesh that is or is not replaced, and the first time at which a mesh that stays is too coarse.
void RunRecorder::note_events(const FlowRecord& record, const surface3d::StepView& view) {
  const double t = record.time;
  const surface3d::Resolution& r = view.resolution;
  if (const auto& made = view.remeshed) {
    const surface3d::RemeshReport& report = made->report;
    events_->append(event_line(t, made->mesh ? "remeshed" : "not-remeshed", report.triangles_before,
                               r, report));
    if (made->mesh)
      say(
          fmt::format("t = {:.6g}: {}; {} new triangles for {}, smallest angle {:.0f} degrees "
                      "after {:.0f}, energy changed by {:.1e}",
                      t, reasons(r), report.triangles_after, report.triangles_before,
                      report.min_angle_after, report.min_angle_before, report.energy_change));
    else
      say(fmt::format("t = {:.6g}: no new triangles: {}", t, made->refusal));
    if (made->mesh) return;
  }
  const bool may_change = input_.numerics.remesh && !view.memory.remeshing_over;
  if (unresolved_from_ || may_change || surface3d::resolved(r)) return;
  unresolved_from_ = t;
  events_->append(event_line(t, "unresolved", view.mesh->count(), r, {}));
  say(fmt::format(
      "unresolved from t = {:.6g}: {}{}", t, reasons(r),
      input_.numerics.remesh ? "" : "; more triangles, or [numerics] remesh = true, may help"));
}

// From time to time. Where there is no room the run goes on: of its results nothing is missing.
void RunRecorder::keep(const FlowRecord& record, const State& state) {
  using Minutes = std::chrono::duration<double, std::ratio<60>>;
  if (Minutes(steady_clock::now() - kept_).count() < input_.checkpoint_minutes) return;
  try {
    write(folder_ / checkpoint_name, record, state);
  } catch (const OutputError& error) {
    say(fmt::format("{}; the run goes on without this checkpoint", error.what()));
  }
  kept_ = steady_clock::now();
}

void RunRecorder::say(const std::string& line) const {
  tell(fmt::format("{}sbeh: {}\n", terminal_ ? "\r\033[K" : "", line));
}

// On a terminal one line that is rewritten, otherwise a line every minute.
void RunRecorder::show(const FlowRecord& record) {
  using std::chrono::duration;
  const auto now = steady_clock::now();
  if (now - shown_ < std::chrono::milliseconds(terminal_ ? 200 : 60'000)) return;
  shown_ = now;
  const double per_step = duration<double>(now - began_).count() / steps_;
  const double left = (input_.times.end - record.time) / record.next_step * per_step;
  tell(
      fmt::format("{}t = {:.4g} of {:.4g}, time step {:.2g}, energy {:.8g}, {:.2g} s a step, "
                  "at most {:.0f} s left{}",
                  terminal_ ? "\r\033[K" : "", record.time, input_.times.end, record.time_step,
                  record.energy.total(), per_step, left, terminal_ ? "" : "\n"));
}

}  // namespace sbeh::studies
