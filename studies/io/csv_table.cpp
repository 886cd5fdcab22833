#include "studies/io/csv_table.h"

#include "studies/io/csv_line.h"
#include "studies/io/output.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <sstream>

namespace sbeh::studies {

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
  return parse_number(text(row, column), value) ? value : std::numeric_limits<double>::quiet_NaN();
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
