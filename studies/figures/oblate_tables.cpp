// The tables of the stationary oblates: figures 1 and 2.
#include "meshing/cross_section.h"
#include "studies/figures/tables.h"
#include "studies/io/csv_table.h"
#include "studies/io/output.h"
#include "studies/scan/scan_table.h"
#include "studies/states/meridian.h"
#include "studies/states/profile_file.h"
#include "surface3d/diagnostics.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

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

// The fields of scan.csv by point; empty where there is none.
class ScanText {
 public:
  explicit ScanText(const Sources& sources) {
    const fs::path file = sources.folder / scan_folder / "scan.csv";
    if (fs::exists(file)) table_ = read_csv(file);
  }
  std::string text(Model model, double v, double L, const char* column) const {
    for (std::size_t row = 0; row < table_.rows.size(); ++row)
      if (table_.text(row, "model") == model::name(model)
          && table_.number(row, "reduced_volume") == v && table_.number(row, "L") == L)
        return table_.text(row, column);
    return "";
  }

 private:
  CsvTable table_;
};

const char* yes_or_no(bool yes) { return yes ? "yes" : "no"; }

// ---- energies -----------------------------------------------------------------------------------

// Adds the history to the text; false when there is none.
bool add_history(std::string& text, const fs::path& series, const std::string& start) {
  if (!fs::exists(series)) return false;
  const CsvTable table = read_csv(series);
  for (std::size_t row = 0; row < table.rows.size(); ++row)
    text += fmt::format("{},{},{}\n", start, table.text(row, "time"), table.text(row, "energy"));
  return !table.rows.empty();
}

// ---- shapes -------------------------------------------------------------------------------------

std::optional<axisym::State> profile(const Sources& sources, Model model, double v, double L) {
  const fs::path file = point_file(sources, model, v, L, ".csv");
  if (!fs::exists(file)) return {};
  return read_profile(file);
}

// The whole cross section of a surface of revolution, closed.
std::string cut_lines(const std::string& start, const Meridian& meridian) {
  std::string text;
  const auto line = [&](Eigen::Index i, double sign) {
    text += fmt::format("{},{},{},{}\n", start, sign * meridian.points()(0, i),
                        meridian.points()(1, i), meridian.order()[i]);
  };
  const Eigen::Index count = meridian.points().cols();
  for (Eigen::Index i = 0; i < count; ++i) line(i, 1);
  for (Eigen::Index i = count - 1; i-- > 0;) line(i, -1);
  return text;
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
  const CsvTable frames = read_csv(found->folder / "frames.csv");
  const fs::path file = found->folder / frames.text(frames.rows.size() - 1, "file");
  Snapshot frame = read_snapshot(file);
  const auto diagnostics = surface3d::diagnose(
      surface3d::Triangulation(frame.mesh), found->input.material, {frame.mesh.nodes, frame.beta});
  return Rest3d{std::move(frame), frames.number(frames.rows.size() - 1, "time"),
                file.lexically_relative(folder).string(), found->ending, diagnostics};
}

// The centre in the origin; these surfaces keep the axis of their ellipsoid, z.
void centre(meshing::CurvedMesh& mesh) {
  const Eigen::Vector3d middle =
      (mesh.nodes.rowwise().maxCoeff() + mesh.nodes.rowwise().minCoeff()) / 2;
  mesh.nodes.colwise() -= middle;
}

// Through the axis, at an angle at which no mesh has a plane of symmetry.
std::string cut_lines(const std::string& start, const Rest3d& rest) {
  constexpr double angle = 0.3;
  const Eigen::Vector3d along(std::cos(angle), std::sin(angle), 0);
  std::string text;
  for (const meshing::CrossSection& curve :
       meshing::cross_section(rest.frame.mesh, rest.frame.beta, Eigen::Vector3d::Zero(),
                              along.cross(Eigen::Vector3d::UnitZ())))
    for (Eigen::Index i = 0; i < curve.values.size(); ++i)
      text += fmt::format("{},{:.9g},{:.9g},{:.9g}\n", start, along.dot(curve.points.col(i)),
                          curve.points(2, i), curve.values[i]);
  return text;
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

std::string columns_3d(const std::optional<Rest3d>& rest, const Meridian& meridian) {
  if (!rest) return ",,,,,,,";
  return fmt::format("{},{},{},{},{},{},{:.3g},{}", rest->frame.mesh.triangle_count(), rest->time,
                     rest->ending, rest->diagnostics.energy.total(), rest->diagnostics.order_min,
                     rest->diagnostics.H_abs_max, distance_of_nodes(rest->frame.mesh, meridian),
                     rest->file);
}

}  // namespace

std::vector<std::string> write_energy(const Sources& sources) {
  const std::string header = "solver,model,reduced_volume,L,triangles,at_rest,time,energy\n";
  std::string text = header;
  const ScanText scan(sources);
  std::vector<std::string> missing;
  const std::vector<PlannedRun> wanted = runs_for(Figure::energy, sources.inputs);
  for_each_point(sources.inputs.oblates, [&](double v, double L) {
    for (const Model model : {Model::SBEH, Model::SSH}) {
      const std::string point = fmt::format("{},{},{}", model::name(model), v, L);
      const fs::path series = point_file(sources, model, v, L, ".series.csv");
      if (!add_history(text, series,
                       fmt::format("axisymmetric,{},,{}", point,
                                   yes_or_no(scan.text(model, v, L, "status") == "stationary"))))
        missing.push_back(series.lexically_relative(sources.folder).string());
      const PlannedRun plan = oblate_run(sources.inputs, model, v, L);
      const auto found = sources.find(plan);
      if (found)
        add_history(
            text, found->folder / "series.csv",
            fmt::format("3D,{},{},{}", point, found->input.triangles,
                        found->ended ? yes_or_no(found->ending.starts_with("at rest")) : ""));
      const bool is_wanted = std::any_of(
          wanted.begin(), wanted.end(), [&](const auto& run) { return run.folder == plan.folder; });
      if (is_wanted && !(found && found->ended)) missing.push_back(missing_run(plan, found));
    }
  });
  if (text != header) write_file(sources.folder / "energy.csv", text);
  return missing;
}

std::vector<std::string> write_shapes(const Sources& sources) {
  const std::string header =
      "reduced_volume,L,energy,energy_SSH,order_min,order_max,H_abs_max,order_min_radius,"
      "distance_from_SSH,SSH_distance,triangles,time,ending,energy_3d,order_min_3d,H_abs_max_3d,"
      "distance_3d,frame\n";
  std::string rows, cuts;
  std::vector<std::string> missing;
  const ScanText scan(sources);
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
    const auto sbeh_has = [&](const char* column) { return scan.text(Model::SBEH, v, L, column); };
    rows += fmt::format("{},{},{},{},{},{},{},{:.6g},{:.4g},{:.4g},{}\n", v, L, sbeh_has("energy"),
                        scan.text(Model::SSH, v, L, "energy"), sbeh_has("order_min"),
                        sbeh_has("order_max"), sbeh_has("H_abs_max"), order_min_radius(*sbeh),
                        distance(own, classical), distance(classical, Meridian(*first).centred()),
                        columns_3d(rest, own));
    cuts += rest ? cut_lines(fmt::format("SBEH,3D,{},{}", v, L), *rest)
                 : cut_lines(fmt::format("SBEH,axisymmetric,{},{}", v, L), own);
    cuts += cut_lines(fmt::format("SSH,axisymmetric,{},{}", v, L), classical);
  });
  if (!rows.empty()) {
    write_file(sources.folder / "shapes.csv", header + rows);
    write_file(sources.folder / "cuts.csv", "model,solver,reduced_volume,L,x,z,order\n" + cuts);
  }
  return missing;
}

}  // namespace sbeh::studies::figures
