#include "tools/picture/canvas/csv.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <fstream>
#include <limits>
#include <sstream>

namespace sbeh::picture {
namespace {

std::string read_all(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream text;
  if (stream) text << stream.rdbuf();
  if (!stream || text.fail()) {
    throw InputError(
        fmt::format("{}: cannot be read; give the folder a run has left.", file.string()));
  }
  return text.str();
}

// Splits one line; a quoted field may hold commas and doubled quotes.
std::vector<std::string> split(std::string_view line) {
  std::vector<std::string> fields(1);
  bool quoted = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const char c = line[i];
    if (c == '"' && quoted && i + 1 < line.size() && line[i + 1] == '"') {
      fields.back() += line[++i];
    } else if (c == '"') {
      quoted = !quoted;
    } else if (c == ',' && !quoted) {
      fields.emplace_back();
    } else {
      fields.back() += c;
    }
  }
  return fields;
}

}  // namespace

CsvTable::CsvTable(const std::filesystem::path& file) : file_(file) {
  const std::string text = read_all(file);
  std::size_t line_number = 0;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t newline = text.find('\n', begin);
    const bool complete = newline != std::string::npos;
    std::string_view line(text.data() + begin, (complete ? newline : text.size()) - begin);
    begin = complete ? newline + 1 : text.size();
    ++line_number;
    if (line.ends_with('\r')) line.remove_suffix(1);
    if (line.empty()) continue;

    auto fields = split(line);
    if (header_.empty()) {
      header_ = std::move(fields);
    } else if (fields.size() == header_.size()) {
      rows_.push_back(std::move(fields));
      lines_.push_back(line_number);
    } else if (complete) {
      throw InputError(
          fmt::format("{}:{}: {} fields where the header has {}; mend or remove the line.",
                      file.string(), line_number, fields.size(), header_.size()));
    }
  }
  if (header_.empty()) {
    throw InputError(
        fmt::format("{}: is empty; its first line must name the columns.", file.string()));
  }
}

bool CsvTable::has(std::string_view column) const {
  return std::ranges::find(header_, column) != header_.end();
}

std::size_t CsvTable::column(std::string_view name) const {
  const auto found = std::ranges::find(header_, name);
  if (found == header_.end()) {
    throw InputError(
        fmt::format("{}: has no column '{}'; its first line must name it.", file_.string(), name));
  }
  return static_cast<std::size_t>(found - header_.begin());
}

const std::string& CsvTable::text(std::size_t row, std::size_t column) const {
  return rows_[row][column];
}

double CsvTable::number(std::size_t row, std::size_t column) const {
  std::string_view field = rows_[row][column];
  while (field.starts_with(' ')) field.remove_prefix(1);
  while (field.ends_with(' ')) field.remove_suffix(1);
  if (field.empty()) return std::numeric_limits<double>::quiet_NaN();
  double value = 0.0;
  const auto [end, error] = std::from_chars(field.data(), field.data() + field.size(), value);
  if (error != std::errc() || end != field.data() + field.size()) {
    throw InputError(fmt::format("{}:{}: {} = '{}' is not a number; mend or remove the line.",
                                 file_.string(), lines_[row], header_[column], field));
  }
  return value;
}

std::vector<double> CsvTable::numbers(std::string_view name) const {
  const std::size_t index = column(name);
  std::vector<double> values(rows());
  for (std::size_t row = 0; row < rows(); ++row) values[row] = number(row, index);
  return values;
}

}  // namespace sbeh::picture
