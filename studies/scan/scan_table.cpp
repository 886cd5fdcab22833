#include "studies/scan/scan_table.h"

#include "studies/scan/mode_columns.h"

#include <fmt/format.h>

#include <cmath>

namespace sbeh::studies {

using axisym::Accuracy;
using axisym::Diagnostics;
using axisym::Energy;

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
      measure("energy_area_difference", inside(&Diagnostics::energy, &Energy::area_difference)),
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
      column("interfaces", &Row::interfaces),
      column("fold_reduced_volume", &Row::fold_reduced_volume),
      column("fold_reduced_volume_error", &Row::fold_reduced_volume_error, "{:.3g}"),
  };
  static const Columns<Row> all = with_modes(columns);
  return all;
}

ScanTable scan_table(const OutputFolder& folder) {
  return {folder / "scan.csv", scan_columns(), "scans", "its point computed again"};
}

}  // namespace sbeh::studies
