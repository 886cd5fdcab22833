// Tables with a row for each of some times, of runs that may have been cut short.
#pragma once

#include "studies/io/columns.h"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace sbeh::studies {

struct TimedLine {
  double time;       ///< in the column "time"
  std::string line;  ///< without its end
};

/// The rows of a CSV file with their times, up to the first that is cut off; none where there is no
/// file, or no such column. Throws OutputError when it cannot be read.
std::vector<TimedLine> timed_lines(const std::filesystem::path& path);

/// A table that grows, and goes on where an earlier run left it.
class TimedTable {
 public:
  /// Keeps of the rows that are there those up to a time. Throws OutputError.
  TimedTable(const std::filesystem::path& path, const std::string& header, double until);

  const std::vector<TimedLine>& kept() const { return kept_; }
  /// Of the last row; −1 when there is none.
  double last_time() const { return last_time_; }
  /// Throws OutputError.
  void append(double time, std::string_view line);

 private:
  std::vector<TimedLine> kept_;
  double last_time_;
  AppendFile file_;
};

/// The rows of such lines; those that are damaged are left out.
template <class Row>
std::vector<Row> rows_of(const Columns<Row>& columns, const std::vector<TimedLine>& lines) {
  std::vector<Row> rows;
  for (const TimedLine& line : lines)
    if (auto row = row_of(columns, split_csv(line.line))) rows.push_back(std::move(*row));
  return rows;
}

}  // namespace sbeh::studies
