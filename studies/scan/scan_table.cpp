#include "studies/scan/scan_table.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <sstream>

namespace sbeh::studies {

using axisym::Accuracy;
using axisym::Diagnostics;
using axisym::Energy;
using axisym::Stability3d;

std::string text_of_modes(const Stability3d& modes) {
  if (!modes.negative_directions) return "";
  return modes.unstable.empty() ? "none" : fmt::format("{}", fmt::join(modes.unstable, " "));
}

namespace {

bool read_modes(const std::string& field, Stability3d& modes) {
  modes.unstable.clear();
  if (field == "none") return true;
  std::istringstream numbers(field);
  for (int m = 0; numbers >> m;) modes.unstable.push_back(m);
  return numbers.eof();
}

// A column for each m.
Columns<PointResult> with_each_m(Columns<PointResult> columns, std::string_view name,
                                 std::array<double, axisym::most_modes + 1> Stability3d::*values) {
  for (std::size_t m = 0; m <= axisym::most_modes; ++m)
    columns.push_back(known_column<PointResult>(
        fmt::format("{}_m{}", name, m),
        [ m, values ](auto& row) -> auto& { return (row.modes.*values)[m]; }));
  return columns;
}

}  // namespace

const Columns<PointResult>& scan_columns() {
  using Row = PointResult;
  const auto measure = [](std::string name, auto member) {
    return part_column(std::move(name), &Row::diagnostics, member, "nan");
  };
  const auto error = [](std::string name, auto member) {
    return part_column(std::move(name), &Row::error, member, "nan");
  };
  static const Columns<Row> columns{
      column<Row>("model", inside(&Row::key, &PointKey::model)),
      column<Row>("reduced_volume", inside(&Row::key, &PointKey::reduced_volume)),
      column<Row>("L", inside(&Row::key, &PointKey::L)),
      column<Row>("branch", inside(&Row::key, &PointKey::branch)),
      column("status", &Row::status),
      derived_column<Row>("energy",
                          [](const Row& row) {
                            return row.diagnostics
                                     ? fmt::format("{}", row.diagnostics->energy.total())
                                     : "nan";
                          }),
      measure("energy_distortion", inside(&Diagnostics::energy, &Energy::distortion)),
      measure("energy_bending", inside(&Diagnostics::energy, &Energy::bending)),
      measure("energy_thermotropic", inside(&Diagnostics::energy, &Energy::thermotropic)),
      measure("order_min", &Diagnostics::order_min),
      measure("order_max", &Diagnostics::order_max),
      measure("order_mean", &Diagnostics::order_mean),
      measure("order_std", &Diagnostics::order_std),
      measure("order_variance", &Diagnostics::order_variance),
      measure("H_pole", &Diagnostics::H_pole),
      measure("H_rim", &Diagnostics::H_rim),
      measure("H_abs_max", &Diagnostics::H_abs_max),
      measure("radius_equator", &Diagnostics::radius_equator),
      measure("thickness_pole", &Diagnostics::thickness_pole),
      measure("W2", &Diagnostics::W2),
      measure("area", &Diagnostics::area),
      measure("volume", &Diagnostics::volume),
      column("residual", &Row::residual, "{:.3g}"),
      column("steps", &Row::steps),
      column("wall_seconds", &Row::wall_seconds, "{:.4g}"),
      column("stop_reason", &Row::stop_reason),
      column("class", &Row::shape),
      column("negative_directions", &Row::negative_directions),
      column("self_contact", &Row::self_contact),
      column("fold_side", &Row::fold_side),
      column("fold_L", &Row::fold_L),
      error("energy_error", &Accuracy::energy),
      error("W2_error", &Accuracy::W2),
      error("H_pole_error", &Accuracy::H_pole),
      column("fold_L_error", &Row::fold_L_error, "{:.3g}"),
      column<Row>("negative_directions_3d", inside(&Row::modes, &Stability3d::negative_directions)),
      {"unstable_modes", [](const Row& row) { return csv_field(text_of_modes(row.modes)); },
       [](Row& row, const std::string& field) { return read_modes(field, row.modes); }},
      known_column<Row>("rigid_residual", inside(&Row::modes, &Stability3d::rigid_residual),
                        "{:.3g}"),
  };
  static const Columns<Row> all = with_each_m(
      with_each_m(columns, "eigenvalue", &Stability3d::eigenvalue), "rate", &Stability3d::rate);
  return all;
}

ScanTable scan_table(const OutputFolder& folder) {
  return {folder / "scan.csv", scan_columns(), "scans", "its point computed again"};
}

}  // namespace sbeh::studies
