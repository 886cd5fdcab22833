#include "studies/io/timed_table.h"

#include "studies/io/csv.h"
#include "studies/io/output.h"

#include <sstream>

namespace sbeh::studies {

std::vector<TimedRow> timed_rows(const std::filesystem::path& path, std::size_t time_column) {
  std::vector<TimedRow> rows;
  if (!std::filesystem::exists(path)) return rows;
  std::istringstream text(read_file(path));
  std::string line, header;
  std::getline(text, header);
  const std::size_t columns = split_csv(header).size();
  while (std::getline(text, line)) {
    const auto fields = split_csv(line);
    double time = 0;
    if (fields.size() != columns || text.eof() || !parse_number(fields[time_column], time)) break;
    rows.push_back({time, line});
  }
  return rows;
}

void keep_until(const std::filesystem::path& path, const std::string& header,
                const std::vector<TimedRow>& rows, double time) {
  std::string text = header + "\n";
  for (const TimedRow& row : rows)
    if (row.time <= time) text += row.line + "\n";
  write_file(path, text);
}

}  // namespace sbeh::studies
