#include "studies/io/csv.h"

#include "studies/io/output.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <sstream>

namespace sbeh::studies {

std::vector<std::string> split_csv(std::string_view line) {
  std::vector<std::string> fields(1);
  bool quoted = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const char c = line[i];
    if (c == '"' && quoted && i + 1 < line.size() && line[i + 1] == '"') {
      fields.back() += c;
      ++i;
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

std::string csv_field(std::string_view text) {
  if (text.find_first_of(",\"\n") == std::string_view::npos) return std::string(text);
  std::string field = "\"";
  for (const char c : text) field += c == '"' ? std::string("\"\"") : std::string(1, c);
  return field + '"';
}

bool parse_number(std::string_view text, double& value) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc() && end == text.data() + text.size();
}

std::optional<std::size_t> CsvTable::find(std::string_view column) const {
  const auto at = std::find(columns.begin(), columns.end(), column);
  if (at == columns.end()) return {};
  return std::size_t(at - columns.begin());
}

std::string CsvTable::text(std::size_t row, std::string_view column) const {
  const auto at = find(column);
  return at ? rows.at(row)[*at] : "";
}

double CsvTable::number(std::size_t row, std::string_view column) const {
  double value = 0;
  return parse_number(text(row, column), value) ? value : not_known;
}

std::string text_of(const CsvTable& table) {
  std::string text;
  const auto add = [&](const std::vector<std::string>& fields) {
    for (std::size_t k = 0; k < fields.size(); ++k)
      text.append(k == 0 ? 0 : 1, ',') += csv_field(fields[k]);
    text += '\n';
  };
  add(table.columns);
  for (const auto& row : table.rows) add(row);
  return text;
}

CsvTable read_csv(const std::filesystem::path& path) {
  std::istringstream text(read_file(path));
  CsvTable table;
  std::string line;
  if (!std::getline(text, line) || text.eof())
    throw OutputError(fmt::format("{}: is empty: compute it again", path.string()));
  table.columns = split_csv(line);
  for (int number = 2; std::getline(text, line) && !text.eof(); ++number) {
    table.rows.push_back(split_csv(line));
    if (table.rows.back().size() != table.columns.size())
      throw OutputError(fmt::format("{}:{}: has {} fields instead of {}: compute it again",
                                    path.string(), number, table.rows.back().size(),
                                    table.columns.size()));
  }
  return table;
}

}  // namespace sbeh::studies
