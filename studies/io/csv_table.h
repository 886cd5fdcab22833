// A whole table of comma separated values: names of the columns, then rows.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace sbeh::studies {

struct CsvTable {
  std::vector<std::string> columns;
  std::vector<std::vector<std::string>> rows;  // each as long as columns

  /// Index of a column; empty when it is not there.
  std::optional<std::size_t> find(std::string_view column) const;
  /// A field, empty when the table has no such column.
  std::string text(std::size_t row, std::string_view column) const;
  /// A field as a number; nan when it is none, or when the table has no such column.
  double number(std::size_t row, std::string_view column) const;
};

/// A last line that was cut off while it was written is left out. Throws OutputError when the file
/// cannot be read, or naming the line that has another number of fields than the first.
CsvTable read_csv(const std::filesystem::path& path);

}  // namespace sbeh::studies
