// The tables of the stationary oblates: figures 1 and 2.
#include "meshing/cross_section.h"
#include "studies/evolution/evolution_files.h"
#include "studies/figures/tables.h"
#include "studies/scan/scan_table.h"
#include "studies/states/meridian.h"
#include "studies/states/profile_file.h"
#include "studies/states/series_file.h"
#include "surface3d/diagnostics.h"

#include <fmt/format.h>

#include <cmath>
#include <map>

namespace sbeh::studies::figures {

namespace fs = std::filesystem;
using model::Model;

namespace {

// The rows of the scan by point; of one that it lacks, one that is not known.
class Scan {
 public:
  explicit Scan(const Sources& sources) {
    const fs::path file = sources.folder / scan_folder / "scan.csv";
    if (fs::exists(file))
      for (const PointResult& row : read_rows(scan_columns(), file)) rows_[row.key] = row;
  }
  bool is_stationary(const PointKey& key) const {
    const auto at = rows_.find(key);
    return at != rows_.end() && at->second.status == PointStatus::stationary;
  }
  axisym::Diagnostics measured(const PointKey& key) const {
    const auto at = rows_.find(key);
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

std::optional<axisym::State> profile(const Sources& sources, const PointKey& key) {
  const fs::path file = point_file(sources.folder / scan_folder, key, ".csv");
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

// What a 3D run has come to, its centre in the origin.
struct Rest3d {
  Snapshot frame;
  ShapeIn3d shape;
};

std::optional<Rest3d> rest_of(const std::optional<FoundRun>& found, const fs::path& folder,
                              const Meridian& profile) {
  if (!found || !found->ended) return {};
  const FrameEntry last = read_rows(frame_columns(), found->folder / "frames.csv").back();
  const fs::path file = found->folder / last.file;
  Snapshot frame = read_snapshot(file);
  Eigen::Matrix3Xd& X = frame.mesh.nodes;
  const auto d = surface3d::diagnose(surface3d::Triangulation(frame.mesh), found->input.material,
                                     {X, frame.beta});
  const Eigen::Vector3d middle = (X.rowwise().maxCoeff() + X.rowwise().minCoeff()) / 2;
  X.colwise() -= middle;
  Eigen::Matrix2Xd rz(2, X.cols());  // the surface keeps the axis of its ellipsoid, z
  for (Eigen::Index i = 0; i < X.cols(); ++i) rz.col(i) << std::hypot(X(0, i), X(1, i)), X(2, i);
  const ShapeIn3d shape{.triangles = frame.mesh.triangle_count(),
                        .time = last.time,
                        .ending = found->ending,
                        .energy = d.energy.total(),
                        .order_min = d.order_min,
                        .H_abs_max = d.H_abs_max,
                        .distance = distance(rz, profile),
                        .frame = file.lexically_relative(folder).string()};
  return Rest3d{std::move(frame), shape};
}

double nine_digits(double value) {
  parse_number(fmt::format("{:.9g}", value), value);
  return value;
}

// Through the axis, at an angle at which no mesh has a plane of symmetry.
void add_cut(std::vector<CutRow>& rows, CutRow row, const Snapshot& frame) {
  constexpr double angle = 0.3;
  const Eigen::Vector3d along(std::cos(angle), std::sin(angle), 0);
  for (const meshing::CrossSection& curve : meshing::cross_section(
           frame.mesh, frame.beta, Eigen::Vector3d::Zero(), along.cross(Eigen::Vector3d::UnitZ())))
    for (Eigen::Index i = 0; i < curve.values.size(); ++i) {
      row.x = nine_digits(along.dot(curve.points.col(i)));
      row.z = nine_digits(curve.points(2, i));
      row.order = nine_digits(curve.values[i]);
      rows.push_back(row);
    }
}

double order_min_radius(const axisym::State& state) {
  Eigen::Index least = 0;
  state.beta.minCoeff(&least);
  return state.X(0, least) / state.X.row(0).maxCoeff();
}

}  // namespace

std::vector<std::string> write_energy(const Sources& sources) {
  std::vector<EnergyRow> rows;
  std::vector<std::string> missing;
  const Scan scan(sources);
  for (const PointKey& key : points_of(sources.inputs.oblates)) {
    EnergyRow row{.solver = Solver::axisymmetric,
                  .model = key.model,
                  .reduced_volume = key.reduced_volume,
                  .L = key.L,
                  .triangles = {},
                  .at_rest = scan.is_stationary(key)};
    const fs::path series = point_file(sources.folder / scan_folder, key, ".series.csv");
    if (!add_history(rows, series, row))
      missing.push_back(series.lexically_relative(sources.folder).string());
    const PlannedRun plan = oblate_run(sources.inputs, key);
    const auto found = sources.find(plan);
    if (found) {
      row.solver = Solver::in_3d;
      row.triangles = found->input.triangles;
      row.at_rest =
          found->ended ? std::optional(found->ending.starts_with("at rest")) : std::nullopt;
      add_history(rows, found->folder / "series.csv", row);
    }
    if (needs_run(Figure::energy, key) && !(found && found->ended))
      missing.push_back(missing_run(plan, found));
  }
  if (!rows.empty()) write_file(sources.folder / "energy.csv", table_text(energy_columns(), rows));
  return missing;
}

std::vector<std::string> write_shapes(const Sources& sources) {
  std::vector<ShapeRow> rows;
  std::vector<CutRow> cuts;
  std::vector<std::string> missing;
  const Scan scan(sources);
  for (const PointKey& key : points_of(sources.inputs.oblates)) {
    if (!needs_run(Figure::shapes, key)) continue;
    const PlannedRun plan = oblate_run(sources.inputs, key);
    const auto found = sources.find(plan);
    if (!(found && found->ended)) missing.push_back(missing_run(plan, found));
    PointKey ssh_key = key, first_key = key;
    ssh_key.model = first_key.model = Model::SSH;
    first_key.L = sources.inputs.oblates.L.front();
    const auto sbeh = profile(sources, key), ssh = profile(sources, ssh_key),
               first = profile(sources, first_key);
    if (!sbeh || !ssh || !first) {
      missing.push_back(
          fmt::format("{}: V_r = {}, L = {}", scan_folder, key.reduced_volume, key.L));
      continue;
    }
    const Meridian own = Meridian(*sbeh).centred(), classical = Meridian(*ssh).centred();
    const std::optional<Rest3d> rest = rest_of(found, sources.folder, own);
    const axisym::Diagnostics d = scan.measured(key);
    rows.push_back({.reduced_volume = key.reduced_volume,
                    .L = key.L,
                    .energy = d.energy.total(),
                    .energy_SSH = scan.measured(ssh_key).energy.total(),
                    .order_min = d.order_min,
                    .order_max = d.order_max,
                    .H_abs_max = d.H_abs_max,
                    .order_min_radius = order_min_radius(*sbeh),
                    .distance_from_SSH = distance(own, classical),
                    .SSH_distance = distance(classical, Meridian(*first).centred()),
                    .in_3d = rest ? std::optional(rest->shape) : std::nullopt,
                    .lacks = rest  ? ""
                           : found ? found->ending
                                   : "not begun"});
    CutRow cut{Model::SBEH, Solver::axisymmetric, key.reduced_volume, key.L};
    CutRow cut_3d = cut, cut_ssh = cut;
    cut_3d.solver = Solver::in_3d;
    cut_ssh.model = Model::SSH;
    if (rest)
      add_cut(cuts, cut_3d, rest->frame);
    else
      add_cut(cuts, cut, own);
    add_cut(cuts, cut_ssh, classical);
  }
  if (!rows.empty()) {
    write_file(sources.folder / "shapes.csv", table_text(shape_columns(), rows));
    write_file(sources.folder / "cuts.csv", table_text(cut_columns(), cuts));
  }
  return missing;
}

}  // namespace sbeh::studies::figures
