// The 3D solver's state in the terms of the axisymmetric methods.
#include "meshing/revolution.h"
#include "meshing/shapes.h"
#include "studies/evolution/evolution_files.h"
#include "studies/evolution/flow_progress.h"
#include "studies/evolution/frame_file.h"
#include "studies/evolution/run_input.h"
#include "studies/io/errors.h"
#include "studies/io/interrupt.h"
#include "studies/io/toml_reader.h"
#include "studies/parameters/material_input.h"
#include "studies/states/series_file.h"
#include "studies/witnesses/surface_nodes.h"
#include "surface3d/flow.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

namespace sbeh::studies {

namespace fs = std::filesystem;
using axisym::StationaryCase;
using surface3d::Triangulation;

namespace {

// A surface with its order, at rest or nearly so; or why there is none.
struct Rest {
  meshing::CurvedMesh mesh{};
  surface3d::Field beta{};  // nodes
  double lambda = not_known;
  std::vector<EnergyAt> history{};
  std::string remark{};
  std::string failure{};
};

// ---- a run of its own ---------------------------------------------------------------------------

Rest start_of(const StationaryCase& of, const SurfaceMethod& method, const axisym::State* profile) {
  const meshing::Resolution resolution{.triangles = method.triangles};
  if (method.revolved) {
    const auto newton = profile ? std::nullopt : newton_state(of).profile;
    if (!profile && !newton) return {.failure = "newton has no state to revolve"};
    meshing::RevolvedMesh revolved = meshing::revolved(profile ? *profile : *newton, resolution);
    return {.mesh = std::move(revolved.mesh), .beta = std::move(revolved.beta)};
  }
  Rest start{.mesh = meshing::ellipsoid(of.reduced_volume, of.branch == axisym::Branch::prolate,
                                        resolution)};
  start.beta = surface3d::Field::Constant(start.mesh.node_count(), model::full_order);
  return start;
}

Rest flow_to_rest(const StationaryCase& of, const SurfaceMethod& method,
                  const axisym::State* profile, const fs::path& keep) {
  Rest rest = start_of(of, method, profile);
  if (!rest.failure.empty()) return rest;
  const auto mesh = std::make_shared<const Triangulation>(rest.mesh);
  const double area = 4 * std::numbers::pi;
  BriefProgress progress(method.end_time, "surface3d: ");
  const FlowMoment start{.mesh = mesh,
                         .state = {rest.mesh.nodes, rest.beta},
                         .target = {area, of.reduced_volume * area / 3}};
  FlowMoment end = start;
  const surface3d::FlowResult run =
      surface3d::run_flow(of.material, of.model, start, method.numerics,
                          {.end_time = method.end_time, .output_times = history_times(method)},
                          [&](const surface3d::FlowRecord& record, const surface3d::State&,
                              const surface3d::StepView& view, bool exact) {
                            if (exact && !method.revolved)
                              rest.history.push_back({record.time, record.energy.total()});
                            progress.see(record);
                            end.fields = view.fields;
                            end.memory = view.memory;
                            return interrupt_signal() == 0;
                          });
  if (run.stop == surface3d::FlowStop::interrupted) throw Interrupted("interrupted");
  const std::string stop = fmt::format(
      "{} triangles, {} at t = {:.4g} after {} steps, speed {:.1e}", rest.mesh.triangle_count(),
      surface3d::describe(run.stop), run.last.time, run.steps, run.last.speed());
  rest.mesh.nodes = run.state.X;
  rest.beta = run.state.beta;
  rest.lambda = run.last.lambda;
  const bool lost = run.stop == surface3d::FlowStop::unresolved
                 || run.stop == surface3d::FlowStop::step_too_small;
  (lost ? rest.failure : rest.remark) = stop;
  end.record = run.last;
  end.state = run.state;
  if (!keep.empty() && surface3d::curvature_of(*mesh, run.state.X))
    write_frame(keep, end, {of.model, of.material});
  return rest;
}

// ---- the run of a folder ------------------------------------------------------------------------

void require_same_case(const fs::path& folder, const RunInput& run, const StationaryCase& of) {
  const auto fail = [&](const std::string& what) {
    throw InputError(fmt::format("{}: is a run of another case: {}", folder.string(), what));
  };
  if (model::rest_model(run.model) != of.model)
    fail(fmt::format("its model is {}, that of the comparison {}", sbeh::name(run.model),
                     sbeh::name(of.model)));
  for (const auto& [name, there, here] :
       differences(run.material, of.material, parameters_of_motion))
    fail(fmt::format("its {} is {}, that of the comparison {}", name, there, here));
}

// Whether the run is the evolution that `flow` follows too: from the same ellipsoid, with the same drag.
bool is_evolution_of(const RunInput& run, const StationaryCase& of) {
  const auto* start = std::get_if<Ellipsoid>(&run.start);
  return start && start->reduced_volume == of.reduced_volume
      && start->prolate == (of.branch == axisym::Branch::prolate) && run.model == of.model
      && run.initial_order == model::full_order && run.perturbation.empty()
      && run.material == of.material;
}

Rest last_frame(const StationaryCase& of, const fs::path& folder) {
  if (!fs::exists(folder / "run.toml") || !fs::exists(folder / "frames.csv"))
    throw InputError(fmt::format(
        "{}: is no folder of a 3D run: it lacks run.toml or frames.csv (run it by: sbeh run)",
        folder.string()));
  const RunInput run = read_run(folder / "run.toml");
  require_same_case(folder, run, of);
  const auto frames = read_rows(frame_columns(), folder / "frames.csv");
  const auto series = read_rows(series_columns(), folder / "series.csv");
  if (frames.empty())
    throw InputError(fmt::format("{}: has no frame yet", (folder / "frames.csv").string()));
  const FlowMoment frame = read_frame(folder / frames.back().file);
  Rest rest{.mesh = curved_mesh(frame), .beta = frame.state.beta};
  const double v = surface3d::reduced_volume(frame.target.area, frame.target.volume);
  if (std::abs(v - of.reduced_volume) > 1e-6)
    throw InputError(
        fmt::format("{}: is a run of another case: its reduced volume is {:.8g}, that of the "
                    "comparison {}",
                    folder.string(), v, of.reduced_volume));
  rest.remark = fmt::format("{} triangles, last frame of {}, t = {:.4g}",
                            rest.mesh.triangle_count(), folder.string(), frame.record.time);
  for (const SeriesRow& row : series)
    if (row.record.time == frame.record.time) {
      rest.lambda = row.record.lambda;
      rest.remark += fmt::format(", |V| = {:.1e}", row.record.speed_max);
    }
  if (is_evolution_of(run, of))
    for (const SeriesRow& row : series)
      rest.history.push_back({row.record.time, row.record.energy.total()});
  return rest;
}

}  // namespace

std::vector<double> history_times(const SurfaceMethod& method) {
  if (method.run.empty()) return evenly_spaced(1e-3, 10, 9, Spacing::logarithmic);
  std::vector<double> times;
  for (const SeriesRow& row : read_rows(series_columns(), fs::path(method.run) / "series.csv"))
    times.push_back(row.record.time);
  return times;
}

WitnessState surface_state(const StationaryCase& of, const SurfaceMethod& method,
                           const axisym::State* profile, const fs::path& keep) {
  const Rest rest =
      method.run.empty() ? flow_to_rest(of, method, profile, keep) : last_frame(of, method.run);
  WitnessState found{.witness = Witness::surface3d, .failure = rest.failure, .remark = rest.remark};
  found.history = rest.history;
  if (!found.failure.empty()) return found;
  const Triangulation mesh(rest.mesh);
  const surface3d::State state{rest.mesh.nodes, rest.beta};
  const auto curvature = surface3d::curvature_of(mesh, state.X);
  if (!curvature) {
    found.failure = "the surface is degenerate";
    return found;
  }
  found.measures =
      measures_of_flow(of.material, surface3d::diagnose(mesh, of.material, state), rest.lambda);
  place_nodes(mesh, state, curvature->H, found);
  found.mesh = rest.mesh;
  return found;
}

}  // namespace sbeh::studies
