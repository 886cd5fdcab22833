// What a scan has left, on its grid: one point per model, reduced volume and L.
#pragma once

#include "studies/scan/scan_table.h"

#include <filesystem>
#include <map>
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
  const std::vector<std::string>& branches() const { return branches_; }

  bool has(Model model) const;
  bool has_series() const;  ///< of any point

  /// nullptr if the scan has no such row.
  const PointResult* find(Model model, std::size_t reduced_volume, std::size_t length) const;

  std::filesystem::path profile(
      const PointResult& point) const;  ///< may be missing for a failed point
  /// Energy over time; there only if the scan was time dependent.
  std::filesystem::path series(const PointResult& point) const;

 private:
  std::filesystem::path directory_;
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
