// Tables with a row for each of some times, of runs that may have been cut short.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace sbeh::studies {

struct TimedRow {
  double time;
  std::string line;  ///< without its end
};

/// The rows of a CSV file with their times, up to the first that is cut off; none where there is no
/// file. Throws OutputError when it cannot be read.
std::vector<TimedRow> timed_rows(const std::filesystem::path& path, std::size_t time_column);

/// Writes the table anew with the rows up to a time. Throws OutputError.
void keep_until(const std::filesystem::path& path, const std::string& header,
                const std::vector<TimedRow>& rows, double time);

}  // namespace sbeh::studies
