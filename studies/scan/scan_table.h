// The table of a scan: one row per point, in the columns that users and pictures rely on.
#pragma once

#include "axisym/diagnostics.h"
#include "axisym/modes/stability_3d.h"
#include "axisym/stationary/accuracy.h"
#include "model/names.h"
#include "studies/io/growing_table.h"
#include "studies/scan/scan_input.h"

#include <optional>
#include <string>

namespace sbeh::studies {

enum class PointStatus {
  stationary,  ///< a state at rest, resolved
  unresolved,  ///< there is none to be had here, or not at this resolution: see the reason
  limit,       ///< a neck has closed: the values are those of what the branch tends to
  failed       ///< the numerics failed
};
constexpr auto names(PointStatus) {
  return std::array{"stationary", "unresolved", "limit", "failed"};
}

/// A row. The diagnostics are of the stationary state, or of the sharpest resolved one.
struct PointResult {
  PointKey key{};
  PointStatus status = PointStatus::failed;
  std::optional<axisym::Diagnostics> diagnostics{};  ///< none: written as nan
  double residual = 0;                               ///< largest force and order residual per area
  std::optional<int> steps{};  ///< time steps of the evolution to rest; none by Newton's method
  double wall_seconds = 0;
  std::string shape{};              ///< class of the shape, see axisym/shape_class.h
  std::optional<int> interfaces{};  ///< between phases of the order, see axisym/domains.h
  std::optional<int>
      negative_directions{};  ///< see axisym/stationary/stability.h; at a fold: before it
  bool self_contact = false;  ///< the surface passes through itself
  std::string fold_side{};    ///< "before" the branch's fold, or "at" it
  /// Of SBEH: the L of the fold of its branch, to which at the fold the diagnostics belong; its estimated error.
  std::optional<double> fold_L{}, fold_L_error{};
  /// The same where the branch folds on its way in V_r: of SSH, and of states with domains.
  std::optional<double> fold_reduced_volume{}, fold_reduced_volume_error{};
  std::string stop_reason{};
  std::optional<axisym::Accuracy>
      error{};  ///< estimated, of the values; none where there is no estimate
  axisym::Stability3d
      modes{};  ///< among shapes without an axis too; unknown where there is no state
};

const Columns<PointResult>& scan_columns();

/// scan.csv of a folder. Throws OutputError when the file is no such table.
using ScanTable = GrowingTable<PointResult>;
ScanTable scan_table(const OutputFolder& folder);

}  // namespace sbeh::studies
