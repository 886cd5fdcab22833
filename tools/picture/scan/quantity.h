// The quantities of a diagram over (reduced volume, L).
#pragma once

#include "tools/picture/chart/colours.h"
#include "tools/picture/scan/scan_grid.h"

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace sbeh::picture {

/// How a point counts. Only the first two have a value.
enum class Mark {
  none,
  limit,       ///< a neck has closed: that of what the branch tends to
  unresolved,  ///< what the row describes is of another L, or not at rest
  failed,
  absent,
  not_found,  ///< a lower state must exist, see studies/scan/lowest.h
  singular    ///< the state is a limit without a smooth shape, which has no such value
};

struct Quantity {
  std::string name{};  ///< as in --panels
  std::string title{};
  studies::Dimension dimension{};
  Palette palette = energy_palette;
  std::vector<std::vector<double>> values{};  ///< [reduced volume][L], NaN without value
  std::vector<std::vector<Mark>> marks{};
  std::vector<std::vector<int>>
      regions{};  ///< no contour crosses from one to another, or enters −1

  /// Where the state is none of the minima among shapes without an axis.
  std::vector<std::vector<bool>> saddles{};

  bool has(Mark mark) const;
  bool has_saddle() const;

  /// Of all values.
  Range range() const;
};

/// Which branch is lowest: values are indices of `names`.
struct BranchMap {
  Quantity quantity;
  std::vector<std::string> names;             ///< first the scan's own, which have rows
  std::vector<std::vector<double>> energies;  ///< of the lowest; NaN where it is not found
  std::size_t rows_of = 0;                    ///< so many of the names are the scan's own

  /// Whether the lowest state has a row.
  bool is_lowest(std::size_t volume, std::size_t length) const {
    const double branch = quantity.values[volume][length];
    return branch < double(rows_of);
  }
};
/// From lowest.csv of the scan's folder; empty without it, and where it has one branch alone. Throws InputError.
std::optional<BranchMap> lowest_branches(const ScanGrid& scan, Model model);
/// Where the lowest state is not found, what was measured of the lowest that was is no value; nor is it where the
/// lowest is a limit, but of an energy: then `of_limit` gives it, from that of the limit.
void show_lowest(const BranchMap& lowest, Quantity& quantity,
                 const std::function<double(std::size_t volume, std::size_t length, double energy)>&
                     of_limit = {});

/// U(SSH) − U(SBEH); of the lowest states where `lowest` is that of SBEH. Order that is free can only lower the energy: where it is negative the state of SBEH is not_found.
Quantity energy_gap(const ScanGrid& scan, const std::optional<BranchMap>& lowest = {});
Quantity energy(const ScanGrid& scan, Model model, const std::optional<BranchMap>& lowest = {});
/// Of SBEH.
Quantity smallest_order(const ScanGrid& scan, const std::optional<BranchMap>& lowest = {});
Quantity largest_curvature(const ScanGrid& scan, Model model,
                           const std::optional<BranchMap>& lowest = {});

/// Its values, at each L, and its title in the units that the user asks for.
Quantity in_units(Quantity quantity, const ScanGrid& scan, const Options& options);

}  // namespace sbeh::picture
