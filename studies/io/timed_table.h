// Tables with a row for each of some times, of runs that may have been cut short.
#pragma once

#include "studies/io/output.h"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace sbeh::studies {

struct TimedRow {
  double time;
  std::string line;  ///< without its end
};

/// The rows of a CSV file with their times, up to the first that is cut off; none where there is no
/// file. Throws OutputError when it cannot be read.
std::vector<TimedRow> timed_rows(const std::filesystem::path& path, std::size_t time_column);

/// A table that grows, and goes on where an earlier run left it.
class TimedTable {
 public:
  /// Keeps of the rows that are there those up to a time. Throws OutputError.
  TimedTable(const std::filesystem::path& path, const std::string& header, std::size_t time_column,
             double until);

  const std::vector<TimedRow>& kept() const { return kept_; }
  /// Of the last row; −1 when there is none.
  double last_time() const { return last_time_; }
  /// Throws OutputError.
  void append(double time, std::string_view line);

 private:
  std::vector<TimedRow> kept_;
  double last_time_;
  AppendFile file_;
};

}  // namespace sbeh::studies
