#include "studies/figures/runs.h"

#include "studies/evolution/event_log.h"
#include "studies/evolution/evolution_files.h"
#include "studies/evolution/frame_file.h"
#include "studies/io/progress.h"
#include "studies/io/stopwatch.h"
#include "studies/mesh_files/mesh_file.h"
#include "studies/parameters/parameters.h"

#include <fmt/format.h>

namespace sbeh::studies::figures {

namespace fs = std::filesystem;

namespace {

constexpr const char* times_name = "run_times.csv";
struct RunTime {
  std::string run;
  double seconds;
};
const Columns<RunTime>& time_columns() {
  static const Columns<RunTime> columns{column("run", &RunTime::run),
                                        column("seconds", &RunTime::seconds, "{:.1f}")};
  return columns;
}

std::string start_text(const RunInput& input) {
  if (const auto* e = std::get_if<Ellipsoid>(&input.start))
    return e->reduced_volume
             ? fmt::format("{} ellipsoid of reduced volume {}",
                           e->prolate ? "a prolate" : "an oblate", *e->reduced_volume)
             : "an ellipsoid of given axes";
  if (const auto* h = std::get_if<HarmonicSphere>(&input.start)) {
    std::string modes;
    for (const meshing::Harmonic& mode : h->modes)
      modes += fmt::format(" [{}, {}, {}]", mode.l, mode.m, mode.amplitude);
    return "a sphere with modes" + modes;
  }
  return "a file";
}

// What makes the run another case than the planned one; empty when it is that.
std::string difference(const RunInput& run, const RunInput& plan, std::optional<int> triangles) {
  const auto differ = [](const char* what, const auto& a, const auto& b) {
    return fmt::format("its {} is {}, that of the figure is {}", what, a, b);
  };
  if (run.model != plan.model)
    return differ("model", sbeh::name(run.model), sbeh::name(plan.model));
  if (start_text(run) != start_text(plan))
    return differ("start", start_text(run), start_text(plan));
  if (run.perturbation != plan.perturbation) return "its perturbation is not that of the figure";
  if (run.symmetry != plan.symmetry)
    return "the symmetry of its triangles is not that of the figure";
  if (run.initial_order != plan.initial_order)
    return differ("order", run.initial_order, plan.initial_order);
  for (const Difference& of : differences(run.material, plan.material))
    return differ(of.name.c_str(), of.first, of.second);
  if (triangles && run.triangles != *triangles)
    return differ("number of triangles", run.triangles, *triangles);
  return "";
}

std::optional<double> unresolved_from(const fs::path& run) {
  if (!fs::exists(run / "events.csv")) return {};
  for (const EventRow& row : read_rows(event_columns(), run / "events.csv"))
    if (row.event == "unresolved") return row.time;
  return {};
}

}  // namespace

std::optional<FoundRun> find_run(const fs::path& folder, const PlannedRun& plan,
                                 std::optional<int> triangles) {
  const fs::path place = folder / plan.folder;
  if (!fs::exists(place / "run.toml")) return {};
  FoundRun found{place, read_run(place / "run.toml"), false, "not begun", unresolved_from(place)};
  if (const std::string what = difference(found.input, plan.input, triangles); !what.empty())
    throw OutputError(
        fmt::format("{}: holds another run: {} (see its run.toml); choose another "
                    "folder with -o, or move that run away",
                    place.string(), what));
  if (!fs::exists(place / "frames.csv")) return found;
  const auto frames = read_rows(frame_columns(), place / "frames.csv");
  if (frames.empty()) return found;
  const double time = frames.back().time;
  const std::optional<model::FlowStop> end = time >= found.input.times.end * (1 - model::same_time)
                                               ? model::FlowStop::end_time
                                               : read_frame(place / frames.back().file).record.ends;
  found.ended = end.has_value();
  found.ending = end ? fmt::format("{} at t = {:.6g}", model::describe(*end), time)
                     : fmt::format("not finished, its last frame at t = {:.6g}", time);
  return found;
}

std::string missing_run(const PlannedRun& plan, const std::optional<FoundRun>& found) {
  return plan.folder + (found ? ": " + found->ending : "");
}

Snapshot read_snapshot(const fs::path& frame) {
  if (const auto curved = read_curved_mesh(frame))
    if (const auto order = curved->fields.find("order");
        order != curved->fields.end() && curved->mesh.order == 3)
      return {curved->mesh, order->second.row(0).transpose()};
  throw InputError(fmt::format("{}: is no frame of a run", frame.string()));
}

RunSummary complete_run(const fs::path& folder, const PlannedRun& plan,
                        const std::optional<FoundRun>& found, std::string_view version) {
  const fs::path place = folder / plan.folder;
  tell(fmt::format("{}: {}\n", place.string(), found ? "goes on" : "begins"));
  const bool first = !fs::exists(folder / times_name);
  AppendFile times(folder / times_name);
  if (first) times.append(header_of(time_columns()));
  const Stopwatch watch;
  RunSummary summary =
      run_surface(found ? found->input : plan.input, place, version, found.has_value());
  times.append(line_of(time_columns(), RunTime{plan.folder, watch.seconds()}));
  return summary;
}

std::optional<double> seconds_of(const fs::path& folder, const PlannedRun& plan) {
  if (!fs::exists(folder / times_name)) return {};
  std::optional<double> sum;
  for (const RunTime& time : read_rows(time_columns(), folder / times_name))
    if (time.run == plan.folder) sum = sum.value_or(0) + time.seconds;
  return sum;
}

}  // namespace sbeh::studies::figures
