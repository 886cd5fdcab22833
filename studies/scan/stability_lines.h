// Lines of a diagram across which the states of a branch begin or cease to be minima among shapes without an axis.
#pragma once

#include "axisym/modes/eigenmodes.h"
#include "studies/scan/branch_lines.h"

#include <string>
#include <vector>

namespace sbeh::studies {

enum class Along { reduced_volume, L };
constexpr auto names(Along) { return std::array{"reduced_volume", "L"}; }

/// Where the lowest eigenvalue of an m and a parity changes its sign.
struct StabilityLineRow {
  model::Model model;
  axisym::Branch branch;
  int m;
  axisym::Parity parity;
  Along along;  ///< which of the two was solved for; the other is one of the scan's
  double reduced_volume = not_known,
         L = not_known;      ///< the one solved for: not known where it is not located
  double error = not_known;  ///< of the one solved for, estimated
  std::string reason{};      ///< why it is not located, and where it is about
};

/// Between neighbours of the scan whose unstable modes differ, or whose eigenvalues may be beyond zero between them as those of
/// their other neighbours say, and up to the fold where the branch has one between them. SSH's shapes do not depend on L: its lines are solved for once and stand under each L. In parallel;
/// incomplete when interrupted.
std::vector<StabilityLineRow> find_stability_lines(const ScanInput& input, const ScanTable& table,
                                                   const PointLookup& point);

/// Of stability_lines.csv.
const Columns<StabilityLineRow>& stability_line_columns();

}  // namespace sbeh::studies
