// What a scan has left, on its grid: one point per model, reduced volume and L; or, over one number of the material at one L, that
// number in the place of L.
#pragma once

#include "studies/scan/scan_table.h"

#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <vector>

namespace sbeh::picture {

using model::Model;
using studies::PointResult;
using studies::PointStatus;

class ScanGrid {
 public:
  /// Reads DIR/scan.csv. With several branches at a point the one of lowest energy is taken, or only
  /// `branch` if that is not empty. Throws InputError and OutputError.
  ScanGrid(const std::filesystem::path& directory, const std::string& branch);

  /// Increasing.
  const std::vector<double>& reduced_volumes() const { return reduced_volumes_; }
  const std::vector<double>& lengths() const { return lengths_; }  ///< the values of L
  /// Of the axis of these, "elastic constant L", and of one of the values, "L = 0.05".
  const std::string& length_axis() const { return length_axis_; }
  std::string length_title(std::size_t length) const;
  const std::vector<std::string>& branches() const { return branches_; }

  bool over_L() const { return folders_.empty(); }
  double L_of(std::size_t length) const { return over_L() ? lengths_[length] : single_L_; }
  /// The rows of one of the scan's tables, their L being what stands on this axis; none where it is not there.
  template <class Row>
  std::vector<Row> rows(const studies::Columns<Row>& columns, const char* table) const {
    std::vector<Row> all;
    const auto add = [&](const std::filesystem::path& folder, const auto& change) {
      if (!std::filesystem::exists(folder / table)) return;
      for (Row& row : studies::read_rows(columns, folder / table)) {
        change(row);
        all.push_back(std::move(row));
      }
    };
    if (over_L()) add(directory_, [](Row&) {});
    for (const auto& [value, folder] : folders_)
      add(directory_ / folder, [place = value](Row& row) { row.L = place; });
    return all;
  }

  bool has(Model model) const;
  bool has_series() const;  ///< of any point

  /// nullptr if the scan has no such row.
  const PointResult* find(Model model, std::size_t reduced_volume, std::size_t length) const;

  /// Of what `find` gives; may be missing for a failed point.
  std::filesystem::path profile(const PointResult& point) const;
  /// Energy over time; there only if the scan was time dependent.
  std::filesystem::path series(const PointResult& point) const;

 private:
  std::filesystem::path folder_of(const PointResult& point) const;  // one of find()
  void read(const std::filesystem::path& folder, const std::optional<double>& in_place_of_L,
            const std::string& branch);

  std::filesystem::path directory_;
  std::string length_name_ = "L", length_axis_ = "elastic constant L";
  double single_L_ = 0;
  std::map<double, std::string>
      folders_;  ///< of the layers, by these values; none: of a scan without
  std::set<double> volumes_read_, lengths_read_;
  std::set<std::string> branches_read_;
  std::vector<double> reduced_volumes_;
  std::vector<double> lengths_;
  std::vector<std::string> branches_;
  std::map<std::tuple<Model, double, double>, PointResult> points_;
};

/// NaN where there is no state.
double energy_of(const PointResult& point);

/// At most `count` of the indices 0 … size − 1, evenly spread, with the first and the last.
std::vector<std::size_t> evenly_spread(std::size_t size, std::size_t count);

}  // namespace sbeh::picture
