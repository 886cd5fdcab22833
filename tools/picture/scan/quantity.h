// The quantities of a diagram over (reduced volume, L).
#pragma once

#include "tools/picture/canvas/geometry.h"
#include "tools/picture/scan/scan_grid.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace sbeh::picture {

/// How a point counts. Only the first two have a value; not_found: a lower state must exist, see studies/scan/lowest.h.
enum class Mark { none, unresolved, failed, absent, not_found };

struct Quantity {
  std::string title{};
  std::vector<std::vector<double>> values{};  ///< [reduced volume][L], NaN without value
  std::vector<std::vector<Mark>> marks{};
  std::vector<std::vector<int>>
      regions{};  ///< no contour crosses from one to another, or enters −1

  bool has(Mark mark) const;

  /// Of the stationary points and of the unresolved ones that are not far away from them.
  Range range() const;
};

/// Which branch is lowest: values are indices of `names`.
struct BranchMap {
  Quantity quantity;
  std::vector<std::string> names;
};
/// From lowest.csv of the scan's folder; empty without it, and where it has one branch alone. Throws InputError.
std::optional<BranchMap> lowest_branches(const ScanGrid& scan,
                                         const std::filesystem::path& directory, Model model);
/// Where the lowest state is not found, what was measured of the lowest that was is no value.
void mark_not_found(const BranchMap& lowest, Quantity& quantity);

/// U(SSH) − U(SBEH). Order that is free can only lower the energy: where it is negative the state of SBEH is not_found.
Quantity energy_gap(const ScanGrid& scan);
Quantity energy(const ScanGrid& scan, Model model);
Quantity smallest_order(const ScanGrid& scan);  ///< of SBEH
Quantity largest_curvature(const ScanGrid& scan, Model model);

}  // namespace sbeh::picture
