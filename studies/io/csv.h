// Tables of comma separated values as text: names of the columns, then rows.
#pragma once

#include <filesystem>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace sbeh::studies {

/// Fields in double quotes may contain commas and doubled quotes; the quotes are taken off.
std::vector<std::string> split_csv(std::string_view line);

/// The text as a field: in quotes where it needs them.
std::string csv_field(std::string_view text);

/// The value of a number that is not known.
inline constexpr double not_known = std::numeric_limits<double>::quiet_NaN();

/// The whole text as a number (nan and inf included). False when it is none.
bool parse_number(std::string_view text, double& value);

struct CsvTable {
  std::vector<std::string> columns;
  std::vector<std::vector<std::string>> rows;  // each as long as columns

  /// Index of a column; empty when it is not there.
  std::optional<std::size_t> find(std::string_view column) const;
  /// A field, empty when the table has no such column.
  std::string text(std::size_t row, std::string_view column) const;
  /// A field as a number; `not_known` when it is none, or when the table has no such column.
  double number(std::size_t row, std::string_view column) const;
};

/// The table as it stands in a file.
std::string text_of(const CsvTable& table);

/// A last line that was cut off while it was written is left out. Throws OutputError when the file
/// cannot be read, or naming the line that has another number of fields than the first.
CsvTable read_csv(const std::filesystem::path& path);

}  // namespace sbeh::studies
