// The tables of the evolution from the perturbed sphere: figures 3 and 4.
#include "studies/evolution/evolution_files.h"
#include "studies/figures/tables.h"
#include "studies/states/series_file.h"
#include "studies/witnesses/state.h"
#include "surface3d/diagnostics.h"
#include "surface3d/moments.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

namespace sbeh::studies::figures {

namespace fs = std::filesystem;
using model::Model;

namespace {

constexpr double nearness = 0.1;  // of a frame to an instant, relative

const FrameEntry* nearest_frame(const std::vector<FrameEntry>& frames, double instant) {
  const FrameEntry* nearest = nullptr;
  const auto away = [&](const FrameEntry& frame) { return std::abs(frame.time - instant); };
  for (const FrameEntry& frame : frames)
    if (away(frame) <= nearness * instant && (!nearest || away(frame) < away(*nearest)))
      nearest = &frame;
  return nearest;
}

// Energies of the stationary oblate: with the run's residual stiffness and with none.
struct Oblates {
  double same = not_known, plain = not_known;
};

Oblates oblates_of(const FoundRun& run) {
  const auto series = read_rows(series_columns(), run.folder / "series.csv");
  if (series.empty()) return {};
  axisym::StationaryCase oblate{.model = run.input.model,
                                .reduced_volume = series.front().reduced_volume,
                                .material = run.input.material};
  Oblates energies{.same = newton_state(oblate).measures.energy};
  oblate.material.residual_stiffness = 0;
  energies.plain = newton_state(oblate).measures.energy;
  return energies;
}

EvolutionState state_of(const FoundRun& run, const FrameEntry& entry, const Oblates& oblates,
                        const fs::path& folder) {
  const fs::path file = run.folder / entry.file;
  const Snapshot frame = read_snapshot(file);
  const surface3d::Triangulation mesh(frame.mesh);
  const auto d = surface3d::diagnose(mesh, run.input.material, {frame.mesh.nodes, frame.beta});
  const Eigen::Vector3d moments = moments_of(samples_of(mesh, frame.mesh.nodes)).principal;
  return {.time = entry.time,
          .energy = d.energy.total(),
          .energy_oblate = oblates.same,
          .energy_oblate_k0_0 = oblates.plain,
          .reduced_volume = d.reduced_volume,
          .order_min = d.order_min,
          .order_max = d.order_max,
          .H_abs_max = d.H_abs_max,
          .moments = {moments[0], moments[1], moments[2]},
          .frame = file.lexically_relative(folder).string()};
}

}  // namespace

std::vector<std::string> write_evolution(const Sources& sources) {
  std::vector<EvolutionRow> rows;
  std::vector<std::string> missing;
  for (const Model model : {Model::SBEH, Model::SSH}) {
    const PlannedRun plan = evolution_run(sources.inputs, model);
    const auto found = sources.find(plan);
    if (!found || !fs::exists(found->folder / "frames.csv")) {
      missing.push_back(plan.folder);
      continue;
    }
    const auto frames = read_rows(frame_columns(), found->folder / "frames.csv");
    const Oblates oblates = oblates_of(*found);
    std::vector<double> none;  // instants without a frame
    for (const double instant : instants) {
      EvolutionRow row{model, found->input.material.residual_stiffness, instant, {}};
      if (const FrameEntry* frame = nearest_frame(frames, instant))
        row.nearest = state_of(*found, *frame, oblates, sources.folder);
      else
        none.push_back(instant);
      rows.push_back(row);
    }
    if (!none.empty())
      missing.push_back(
          fmt::format("{} at t = {} ({})", plan.folder, fmt::join(none, ", "), found->ending));
  }
  if (!rows.empty())
    write_file(sources.folder / "evolution.csv", table_text(evolution_columns(), rows));
  return missing;
}

std::vector<std::string> write_measures(const Sources& sources) {
  std::vector<MeasureRow> rows;
  std::vector<std::string> missing;
  for (const Model model : {Model::SBEH, Model::SSH}) {
    const PlannedRun plan = evolution_run(sources.inputs, model);
    const auto found = sources.find(plan);
    if (!found || !found->ended) missing.push_back(missing_run(plan, found));
    if (!found || !fs::exists(found->folder / "series.csv")) continue;
    for (const SeriesRow& at : read_rows(series_columns(), found->folder / "series.csv"))
      rows.push_back({.model = model,
                      .residual_stiffness = found->input.material.residual_stiffness,
                      .unresolved_from = found->unresolved_from,
                      .time = at.record.time,
                      .energy = at.record.energy.total(),
                      .W2 = at.W2,
                      .order_std = at.order_std,
                      .order_variance = at.order_variance,
                      .reduced_volume = at.reduced_volume,
                      .ended = found->ended});
  }
  if (!rows.empty())
    write_file(sources.folder / "measures.csv", table_text(measure_columns(), rows));
  return missing;
}

}  // namespace sbeh::studies::figures
