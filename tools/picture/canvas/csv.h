// Comma-separated tables: a header line, then rows; fields may be quoted.
#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace sbeh::picture {

/// What the user gave cannot be read; the message is one sentence with the file and what to do.
struct InputError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

class CsvTable {
 public:
  /// Reads the whole file; throws InputError. A last line that was cut off while it was written is left out.
  explicit CsvTable(const std::filesystem::path& file);

  std::size_t rows() const { return rows_.size(); }
  bool has(std::string_view column) const;

  /// Index of a column by its name in the header; throws InputError if it is not there.
  std::size_t column(std::string_view name) const;

  const std::string& text(std::size_t row, std::size_t column) const;

  /// NaN for an empty field; throws InputError with file and line for a field that is not a number.
  double number(std::size_t row, std::size_t column) const;

  /// All rows of one column as numbers.
  std::vector<double> numbers(std::string_view name) const;

 private:
  std::filesystem::path file_;
  std::vector<std::string> header_;
  std::vector<std::vector<std::string>> rows_;
  std::vector<std::size_t> lines_;  // line in the file of each row
};

}  // namespace sbeh::picture
