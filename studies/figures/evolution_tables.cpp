// The tables of the evolution from the perturbed sphere: figures 3 and 4.
#include "studies/figures/tables.h"
#include "studies/io/csv_table.h"
#include "studies/io/output.h"
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

// The row of frames.csv nearest in time.
std::optional<std::size_t> nearest_frame(const CsvTable& frames, double instant) {
  std::optional<std::size_t> nearest;
  const auto away = [&](std::size_t row) { return std::abs(frames.number(row, "time") - instant); };
  for (std::size_t row = 0; row < frames.rows.size(); ++row)
    if (away(row) <= nearness * instant && (!nearest || away(row) < away(*nearest))) nearest = row;
  return nearest;
}

double energy_of_oblate(const RunInput& input, double reduced_volume, double residual_stiffness) {
  axisym::StationaryCase oblate{
      .model = input.model, .reduced_volume = reduced_volume, .material = input.material};
  oblate.material.residual_stiffness = residual_stiffness;
  return newton_state(oblate).found.measures.energy;
}

// Energies of the stationary oblate: with the run's residual stiffness and with none.
struct Oblates {
  double same = not_known, plain = not_known;
};

std::string evolution_row(const FoundRun& run, double time, const Oblates& oblates,
                          const fs::path& file, const fs::path& folder) {
  const Snapshot frame = read_snapshot(file);
  const surface3d::Triangulation mesh(frame.mesh);
  const auto d = surface3d::diagnose(mesh, run.input.material, {frame.mesh.nodes, frame.beta});
  const Eigen::Vector3d moments = moments_of(samples_of(mesh, frame.mesh.nodes)).principal;
  return fmt::format("{},{},{},{},{},{},{},{},{:.9g},{:.9g},{:.9g},{}\n", time, d.energy.total(),
                     oblates.same, oblates.plain, d.reduced_volume, d.order_min, d.order_max,
                     d.H_abs_max, moments[0], moments[1], moments[2],
                     file.lexically_relative(folder).string());
}

}  // namespace

std::vector<std::string> write_evolution(const Sources& sources) {
  std::string rows;
  std::vector<std::string> missing;
  for (const Model model : {Model::SBEH, Model::SSH}) {
    const PlannedRun plan = evolution_run(sources.inputs, model);
    const auto found = sources.find(plan);
    if (!found || !fs::exists(found->folder / "frames.csv")) {
      missing.push_back(plan.folder);
      continue;
    }
    const CsvTable frames = read_csv(found->folder / "frames.csv"),
                   series = read_csv(found->folder / "series.csv");
    Oblates oblates;
    if (!series.rows.empty()) {
      const double v = series.number(0, "reduced_volume");
      oblates.same = energy_of_oblate(found->input, v, found->input.material.residual_stiffness);
      oblates.plain = energy_of_oblate(found->input, v, 0);
    }
    std::vector<double> none;  // instants without a frame
    for (const double instant : instants) {
      rows += fmt::format("{},{},{},", model::name(model), found->input.material.residual_stiffness,
                          instant);
      const auto row = nearest_frame(frames, instant);
      if (row)
        rows += evolution_row(*found, frames.number(*row, "time"), oblates,
                              found->folder / frames.text(*row, "file"), sources.folder);
      else
        rows += ",,,,,,,,,,,\n";
      if (!row) none.push_back(instant);
    }
    if (!none.empty())
      missing.push_back(
          fmt::format("{} at t = {} ({})", plan.folder, fmt::join(none, ", "), found->ending));
  }
  if (!rows.empty())
    write_file(sources.folder / "evolution.csv",
               "model,residual_stiffness,instant,time,energy,energy_oblate,energy_oblate_k0_0,"
               "reduced_volume,order_"
               "min,order_max,"
               "H_abs_max,moment_1,moment_2,moment_3,frame\n"
                   + rows);
  return missing;
}

std::vector<std::string> write_measures(const Sources& sources) {
  std::string rows;
  std::vector<std::string> missing;
  for (const Model model : {Model::SBEH, Model::SSH}) {
    const PlannedRun plan = evolution_run(sources.inputs, model);
    const auto found = sources.find(plan);
    if (!found || !found->ended)
      missing.push_back(plan.folder + (found ? ": " + found->ending : ""));
    if (!found || !fs::exists(found->folder / "series.csv")) continue;
    const CsvTable series = read_csv(found->folder / "series.csv");
    for (std::size_t row = 0; row < series.rows.size(); ++row) {
      rows +=
          fmt::format("{},{},{}", model::name(model), found->input.material.residual_stiffness,
                      found->unresolved_from ? fmt::format("{:.6g}", *found->unresolved_from) : "");
      for (const char* column :
           {"time", "energy", "W2", "order_std", "order_variance", "reduced_volume"})
        rows += fmt::format(",{}", series.text(row, column));
      rows += "\n";
    }
  }
  if (!rows.empty())
    write_file(sources.folder / "measures.csv",
               "model,residual_stiffness,unresolved_from,time,energy,W2,order_std,order_variance,"
               "reduced_volume\n"
                   + rows);
  return missing;
}

std::vector<std::string> write_tables(Figure figure, const Sources& sources) {
  switch (figure) {
    case Figure::energy:
      return write_energy(sources);
    case Figure::shapes:
      return write_shapes(sources);
    case Figure::evolution:
      return write_evolution(sources);
    case Figure::measures:
      return write_measures(sources);
  }
  return {};
}

}  // namespace sbeh::studies::figures
