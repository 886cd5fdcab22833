// A table that grows row by row while it is computed, and can be gone on with.
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

}  // namespace sbeh::studies
