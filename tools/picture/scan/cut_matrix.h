// Which cuts of a scan are shown, and in which row and column.
#pragma once

#include "tools/picture/scan/scan_grid.h"
#include "tools/picture/section/panels.h"

#include <map>
#include <string>
#include <vector>

namespace sbeh::picture {

/// Rows are reduced volumes, columns are values of L; a larger scan is thinned out evenly. With a single
/// L the reduced volumes stand side by side. Below follow the overlays, all L of one reduced volume in
/// a cell. Reduced volumes and L are given by their index in the scan.
class CutMatrix {
 public:
  /// Reads the profiles that are shown; throws InputError.
  explicit CutMatrix(const ScanGrid& scan);

  bool empty() const { return cuts_.empty(); }
  const ScanGrid& scan() const { return scan_; }
  const OrderRange& orders() const { return orders_; }  ///< of the cuts of SBEH

  std::size_t rows() const { return is_row_ ? 1 : volumes_.size(); }
  std::size_t columns() const { return is_row_ ? volumes_.size() : lengths_.size(); }
  std::size_t volume(std::size_t row, std::size_t column) const;
  std::size_t length(std::size_t row, std::size_t column) const;

  /// One overlay for each of these, in so many rows of at most columns() cells.
  const std::vector<std::size_t>& volumes() const { return volumes_; }
  std::size_t overlay_rows() const;

  /// nullptr if there is none.
  const Cut* cut(Model model, std::size_t volume, std::size_t length) const;

  std::string title() const;
  std::string row_title(std::size_t row) const;
  std::string column_title(std::size_t column) const;

  /// What to say about a point that is not simply stationary; empty for the others.
  std::string remark(std::size_t volume, std::size_t length) const;
  bool any_remark() const;

  /// Of the widest cut.
  double half_width() const { return extent_.half_width; }

  /// Of the highest cut in each row, overlays included.
  std::vector<double> half_heights() const;

 private:
  const ScanGrid& scan_;
  std::vector<std::size_t> volumes_;
  std::vector<std::size_t> lengths_;
  bool is_row_;
  std::map<const PointResult*, Cut> cuts_;
  Extent extent_;
  OrderRange orders_;
};

}  // namespace sbeh::picture
