// Which branch is lowest at every point of a scan, and where none that was found can be.
//
// A state at L is a shape and an order like any other at another L, where its energy, linear in L, is an upper bound
// of the least. So is that of SSH's states for SBEH: β = 2/3 is one order among others.
#pragma once

#include "studies/scan/beyond_fold.h"
#include "studies/scan/scan_table.h"

#include <string>
#include <vector>

namespace sbeh::studies {

/// In the place of a branch: a lower state than any that was found must exist.
inline constexpr const char* not_found = "not found";

/// The branch of lowest energy at a point.
struct LowestRow {
  model::Model model;
  double L, reduced_volume;
  /// A Branch; or "sharp_oblate" or "nested_spheres", see beyond_fold.h; or `not_found`.
  std::string branch;
  double energy = not_known;  ///< none where it is not found
  double bound =
      not_known;  ///< least energy at this L of the scan's other states of that reduced volume
  std::string bound_of{};  ///< which: "SSH stomatocyte", "SBEH stomatocyte of L = 0.0002"
  /// Of the lowest, see Stability3d: above 0 it is a saddle among shapes without an axis. Empty where not known.
  std::optional<int> negative_directions_3d{};
};

/// At every L and reduced volume the lowest of each model's stationary states, and for SBEH of the sharp and the nested
/// ones among `beyond`, unless the bound lies below it by more than energies may be off: then it is not found. No row where
/// there is neither. States that pass through themselves do not count.
std::vector<LowestRow> find_lowest(const StateGrid& grid, const ScanTable& table,
                                   const std::vector<RimRow>& beyond);

/// Of lowest.csv.
const Columns<LowestRow>& lowest_columns();

/// Whether the first energy is below the second by more than rows of a scan may be off.
inline bool is_below(double first, double second) {
  constexpr double rounding = 1e-7;
  return first < second - rounding * std::abs(second);
}

}  // namespace sbeh::studies
