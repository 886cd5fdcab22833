// Tables that grow row by row while they are computed, and can be gone on with.
#pragma once

#include "studies/io/columns.h"

#include <map>
#include <sstream>

namespace sbeh::studies {

/// Rows by their member `key`.
template <class Row>
class GrowingTable {
 public:
  using Key = decltype(Row::key);

  /// Reads the rows there are; a last line that was cut off is dropped. Throws OutputError when the file is
  /// no table of `kind`, or naming a line that is damaged, which is to be deleted "to have `what`".
  GrowingTable(std::filesystem::path path, const Columns<Row>& columns, std::string_view kind,
               std::string_view what)
      : path_(std::move(path)), columns_(columns) {
    if (std::filesystem::exists(path_)) read(kind, what);
    sort();
  }

  const std::map<Key, Row>& rows() const { return rows_; }
  const Row* find(const Key& key) const {
    const auto at = rows_.find(key);
    return at == rows_.end() ? nullptr : &at->second;
  }
  /// Adds a row to file and memory.
  void append(const Row& row) {
    file_->append(line_of(columns_, row));
    rows_.insert_or_assign(row.key, row);
  }
  /// Rewrites the file in the order of the keys.
  void sort() {
    file_.reset();
    std::string text = header_of(columns_) + "\n";
    for (const auto& [key, row] : rows_) text += line_of(columns_, row) + "\n";
    write_file(path_, text);
    file_.emplace(path_);
  }

 private:
  void read(std::string_view kind, std::string_view what) {
    std::istringstream text(read_file(path_));
    std::string line;
    if (!std::getline(text, line) || line != header_of(columns_))
      throw OutputError(
          fmt::format("{}: is no table of this version's {}; choose another folder with -o or move "
                      "the old one away",
                      path_.string(), kind));
    for (int number = 2; std::getline(text, line) && !text.eof(); ++number) {
      const auto row = row_of(columns_, split_csv(line));
      if (!row)
        throw OutputError(fmt::format("{}:{}: is damaged; delete that line to have {}",
                                      path_.string(), number, what));
      rows_.insert_or_assign(row->key, *row);
    }
  }

  std::filesystem::path path_;
  const Columns<Row>& columns_;
  std::map<Key, Row> rows_;
  std::optional<AppendFile> file_;
};

// ---- rows for some times, of runs that may have been cut short ----------------------------------

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
