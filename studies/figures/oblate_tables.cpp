// The tables of the stationary oblates: figures 1 and 2.
#include "meshing/cross_section.h"
#include "studies/evolution/frame_file.h"
#include "studies/figures/tables.h"
#include "studies/scan/scan_table.h"
#include "studies/states/meridian.h"
#include "studies/states/profile_file.h"
#include "studies/states/series_file.h"
#include "surface3d/diagnostics.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace sbeh::studies::figures {

namespace fs = std::filesystem;
using model::Model;

namespace {

fs::path point_file(const Sources& sources, Model model, double v, double L, const char* ending) {
  return sources.folder / scan_folder / "points"
       / (stem(PointKey{v, L, model, axisym::Branch::oblate}) + ending);
}

template <class Visit>
void for_each_point(const ScanInput& scan, Visit&& visit) {
  for (const double v : scan.reduced_volume)
    for (const double L : scan.L) visit(v, L);
}

std::string missing_run(const PlannedRun& plan, const std::optional<FoundRun>& found) {
  return plan.folder + (found ? ": " + found->ending : "");
}

// The rows of the scan by point.
class Scan {
 public:
  explicit Scan(const Sources& sources) {
    const fs::path file = sources.folder / scan_folder / "scan.csv";
    if (fs::exists(file))
      for (const PointResult& row : read_rows(scan_columns(), file)) rows_[row.key] = row;
  }
  bool is_stationary(Model model, double v, double L) const {
    const auto at = rows_.find({v, L, model, axisym::Branch::oblate});
    return at != rows_.end() && at->second.status == PointStatus::stationary;
  }
  /// Numbers that are not known where there is none.
  axisym::Diagnostics measured(Model model, double v, double L) const {
    const auto at = rows_.find({v, L, model, axisym::Branch::oblate});
    if (at != rows_.end() && at->second.diagnostics) return *at->second.diagnostics;
    axisym::Diagnostics none{};
    none.energy.bending = none.order_min = none.order_max = none.H_abs_max = not_known;
    return none;
  }

 private:
  std::map<PointKey, PointResult> rows_;
};

// ---- energies -----------------------------------------------------------------------------------

// Adds the history, each row with what `row` has already; false when there is none.
bool add_history(std::vector<EnergyRow>& rows, const fs::path& file, EnergyRow row) {
  if (!fs::exists(file)) return false;
  const auto series = read_rows(series_columns(), file);
  for (const SeriesRow& at : series) {
    row.time = at.record.time;
    row.energy = at.record.energy.total();
    rows.push_back(row);
  }
  return !series.empty();
}

// ---- shapes -------------------------------------------------------------------------------------

std::optional<axisym::State> profile(const Sources& sources, Model model, double v, double L) {
  const fs::path file = point_file(sources, model, v, L, ".csv");
  if (!fs::exists(file)) return {};
  return read_profile(file);
}

// Adds the whole cross section of a surface of revolution, closed.
void add_cut(std::vector<CutRow>& rows, CutRow row, const Meridian& meridian) {
  const auto add = [&](Eigen::Index i, double sign) {
    row.x = sign * meridian.points()(0, i);
    row.z = meridian.points()(1, i);
    row.order = meridian.order()[i];
    rows.push_back(row);
  };
  const Eigen::Index count = meridian.points().cols();
  for (Eigen::Index i = 0; i < count; ++i) add(i, 1);
  for (Eigen::Index i = count - 1; i-- > 0;) add(i, -1);
}

// What a 3D run has come to.
struct Rest3d {
  Snapshot frame;
  double time;
  std::string file, ending;
  surface3d::Diagnostics diagnostics;
};

std::optional<Rest3d> rest_of(const std::optional<FoundRun>& found, const fs::path& folder) {
  if (!found || !found->ended) return {};
  const FrameEntry last = read_rows(frame_columns(), found->folder / "frames.csv").back();
  const fs::path file = found->folder / last.file;
  Snapshot frame = read_snapshot(file);
  const auto diagnostics = surface3d::diagnose(
      surface3d::Triangulation(frame.mesh), found->input.material, {frame.mesh.nodes, frame.beta});
  return Rest3d{std::move(frame), last.time, file.lexically_relative(folder).string(),
                found->ending, diagnostics};
}

// The centre in the origin; these surfaces keep the axis of their ellipsoid, z.
void centre(meshing::CurvedMesh& mesh) {
  const Eigen::Vector3d middle =
      (mesh.nodes.rowwise().maxCoeff() + mesh.nodes.rowwise().minCoeff()) / 2;
  mesh.nodes.colwise() -= middle;
}

double nine_digits(double value) {
  parse_number(fmt::format("{:.9g}", value), value);
  return value;
}

// Through the axis, at an angle at which no mesh has a plane of symmetry.
void add_cut(std::vector<CutRow>& rows, CutRow row, const Rest3d& rest) {
  constexpr double angle = 0.3;
  const Eigen::Vector3d along(std::cos(angle), std::sin(angle), 0);
  for (const meshing::CrossSection& curve :
       meshing::cross_section(rest.frame.mesh, rest.frame.beta, Eigen::Vector3d::Zero(),
                              along.cross(Eigen::Vector3d::UnitZ())))
    for (Eigen::Index i = 0; i < curve.values.size(); ++i) {
      row.x = nine_digits(along.dot(curve.points.col(i)));
      row.z = nine_digits(curve.points(2, i));
      row.order = nine_digits(curve.values[i]);
      rows.push_back(row);
    }
}

double distance_of_nodes(const meshing::CurvedMesh& mesh, const Meridian& meridian) {
  double largest = 0;
  for (const auto x : mesh.nodes.colwise()) {
    const Eigen::Vector2d rz(std::hypot(x[0], x[1]), x[2]);
    largest = std::max(largest, (meridian.at(meridian.nearest(rz)) - rz).norm());
  }
  return largest;
}

double order_min_radius(const axisym::State& state) {
  Eigen::Index least = 0;
  state.beta.minCoeff(&least);
  return state.X(0, least) / state.X.row(0).maxCoeff();
}

std::optional<ShapeIn3d> shape_of(const std::optional<Rest3d>& rest, const Meridian& meridian) {
  if (!rest) return {};
  return ShapeIn3d{.triangles = rest->frame.mesh.triangle_count(),
                   .time = rest->time,
                   .ending = rest->ending,
                   .energy = rest->diagnostics.energy.total(),
                   .order_min = rest->diagnostics.order_min,
                   .H_abs_max = rest->diagnostics.H_abs_max,
                   .distance = distance_of_nodes(rest->frame.mesh, meridian),
                   .frame = rest->file};
}

}  // namespace

std::vector<std::string> write_energy(const Sources& sources) {
  std::vector<EnergyRow> rows;
  const Scan scan(sources);
  std::vector<std::string> missing;
  const std::vector<PlannedRun> wanted = runs_for(Figure::energy, sources.inputs);
  for_each_point(sources.inputs.oblates, [&](double v, double L) {
    for (const Model model : {Model::SBEH, Model::SSH}) {
      EnergyRow row{.solver = Solver::axisymmetric,
                    .model = model,
                    .reduced_volume = v,
                    .L = L,
                    .triangles = {},
                    .at_rest = scan.is_stationary(model, v, L)};
      const fs::path series = point_file(sources, model, v, L, ".series.csv");
      if (!add_history(rows, series, row))
        missing.push_back(series.lexically_relative(sources.folder).string());
      const PlannedRun plan = oblate_run(sources.inputs, model, v, L);
      const auto found = sources.find(plan);
      if (found) {
        row.solver = Solver::in_3d;
        row.triangles = found->input.triangles;
        row.at_rest =
            found->ended ? std::optional(found->ending.starts_with("at rest")) : std::nullopt;
        add_history(rows, found->folder / "series.csv", row);
      }
      const bool is_wanted = std::any_of(
          wanted.begin(), wanted.end(), [&](const auto& run) { return run.folder == plan.folder; });
      if (is_wanted && !(found && found->ended)) missing.push_back(missing_run(plan, found));
    }
  });
  if (!rows.empty()) write_file(sources.folder / "energy.csv", table_text(energy_columns(), rows));
  return missing;
}

std::vector<std::string> write_shapes(const Sources& sources) {
  std::vector<ShapeRow> rows;
  std::vector<CutRow> cuts;
  std::vector<std::string> missing;
  const Scan scan(sources);
  for_each_point(sources.inputs.oblates, [&](double v, double L) {
    const PlannedRun plan = oblate_run(sources.inputs, Model::SBEH, v, L);
    const auto found = sources.find(plan);
    if (!(found && found->ended)) missing.push_back(missing_run(plan, found));
    const auto sbeh = profile(sources, Model::SBEH, v, L), ssh = profile(sources, Model::SSH, v, L),
               first = profile(sources, Model::SSH, v, sources.inputs.oblates.L.front());
    if (!sbeh || !ssh || !first) {
      missing.push_back(fmt::format("{}: V_r = {}, L = {}", scan_folder, v, L));
      return;
    }
    const Meridian own = Meridian(*sbeh).centred(), classical = Meridian(*ssh).centred();
    std::optional<Rest3d> rest = rest_of(found, sources.folder);
    if (rest) centre(rest->frame.mesh);
    const axisym::Diagnostics d = scan.measured(Model::SBEH, v, L);
    rows.push_back({.reduced_volume = v,
                    .L = L,
                    .energy = d.energy.total(),
                    .energy_SSH = scan.measured(Model::SSH, v, L).energy.total(),
                    .order_min = d.order_min,
                    .order_max = d.order_max,
                    .H_abs_max = d.H_abs_max,
                    .order_min_radius = order_min_radius(*sbeh),
                    .distance_from_SSH = distance(own, classical),
                    .SSH_distance = distance(classical, Meridian(*first).centred()),
                    .in_3d = shape_of(rest, own)});
    const CutRow cut{
        .model = Model::SBEH, .solver = Solver::axisymmetric, .reduced_volume = v, .L = L};
    CutRow cut_3d = cut, cut_ssh = cut;
    cut_3d.solver = Solver::in_3d;
    cut_ssh.model = Model::SSH;
    if (rest)
      add_cut(cuts, cut_3d, *rest);
    else
      add_cut(cuts, cut, own);
    add_cut(cuts, cut_ssh, classical);
  });
  if (!rows.empty()) {
    write_file(sources.folder / "shapes.csv", table_text(shape_columns(), rows));
    write_file(sources.folder / "cuts.csv", table_text(cut_columns(), cuts));
  }
  return missing;
}

}  // namespace sbeh::studies::figures
