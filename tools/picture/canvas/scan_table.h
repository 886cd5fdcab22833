// What a scan has left: one point per model, reduced volume and L.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <tuple>
#include <vector>

namespace sbeh::picture {

enum class Model { SBEH, SSH };
enum class Status { stationary, unresolved, failed };

struct ScanPoint {
  Status status = Status::failed;
  std::string branch;
  double energy = 0.0;
  double order_min = 0.0;
  double H_abs_max = 0.0;
  std::filesystem::path profile;  ///< may be missing for a failed point
  std::filesystem::path series;   ///< energy over time; there only if the scan was time dependent
};

class ScanTable {
 public:
  /// Reads DIR/scan.csv. With several branches at a point the one of lowest energy is taken, or only
  /// `branch` if that is not empty. Throws InputError.
  ScanTable(const std::filesystem::path& directory, const std::string& branch);

  /// Increasing.
  const std::vector<double>& reduced_volumes() const { return reduced_volumes_; }
  const std::vector<double>& lengths() const { return lengths_; }  ///< the values of L
  const std::vector<std::string>& branches() const { return branches_; }

  bool has(Model model) const;

  /// nullptr if the scan has no such row.
  const ScanPoint* find(Model model, std::size_t reduced_volume, std::size_t length) const;

 private:
  using Key = std::tuple<Model, long long, long long>;

  std::vector<double> reduced_volumes_;
  std::vector<double> lengths_;
  std::vector<std::string> branches_;
  std::map<Key, ScanPoint> points_;
};

/// The same for a parameter that is written with other digits in another row.
long long parameter_key(double parameter);

/// A parameter as it is written in a picture: at most four digits.
std::string short_number(double value);

/// At most `count` of the indices 0 … size − 1, evenly spread, with the first and the last.
std::vector<std::size_t> evenly_spread(std::size_t size, std::size_t count);

}  // namespace sbeh::picture
