// stability.csv: a row per perturbed state, in the columns that users and pictures rely on.
#pragma once

#include "studies/io/output.h"
#include "studies/stability/stability_run.h"

#include <filesystem>
#include <map>
#include <optional>
#include <string>

namespace sbeh::studies {

/// The rows of a folder: those that are there, and appending.
class StabilityTable {
 public:
  /// Reads the rows there are; a last line that was cut off is dropped. Throws OutputError when the file
  /// is no such table.
  explicit StabilityTable(const OutputFolder& folder);

  const std::map<StabilityKey, StabilityResult>& rows() const { return rows_; }
  bool has(const StabilityKey& key) const { return rows_.contains(key); }
  /// Adds a row to file and memory.
  void append(const StabilityResult& row);
  /// Rewrites the file in the order of the keys.
  void sort();

 private:
  std::filesystem::path path_;
  std::map<StabilityKey, StabilityResult> rows_;
  std::optional<AppendFile> file_;
};

/// The history of a run: time, time_step, energy, amplitude, normal_speed, order_speed.
std::string history_text(const std::vector<PerturbedAt>& history);

}  // namespace sbeh::studies
