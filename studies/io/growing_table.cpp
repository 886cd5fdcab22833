#include "studies/io/growing_table.h"

#include <algorithm>

namespace sbeh::studies {

namespace {

// Writes the table anew with the rows up to a time, which it returns.
std::vector<TimedLine> keep_until(const std::filesystem::path& path, const std::string& header,
                                  double time) {
  std::vector<TimedLine> rows = timed_lines(path);
  std::erase_if(rows, [&](const TimedLine& row) { return !(row.time <= time); });
  std::string text = header + "\n";
  for (const TimedLine& row : rows) text += row.line + "\n";
  write_file(path, text);
  return rows;
}

}  // namespace

std::vector<TimedLine> timed_lines(const std::filesystem::path& path) {
  std::vector<TimedLine> rows;
  if (!std::filesystem::exists(path)) return rows;
  std::istringstream text(read_file(path));
  std::string line;
  std::getline(text, line);
  const std::vector<std::string> columns = split_csv(line);
  const auto time_column =
      std::size_t(std::find(columns.begin(), columns.end(), "time") - columns.begin());
  if (time_column == columns.size()) return rows;
  while (std::getline(text, line)) {
    const auto fields = split_csv(line);
    double time = 0;
    if (fields.size() != columns.size() || text.eof() || !parse_number(fields[time_column], time))
      break;
    rows.push_back({time, line});
  }
  return rows;
}

TimedTable::TimedTable(const std::filesystem::path& path, const std::string& header, double until)
    : kept_(keep_until(path, header, until)),
      last_time_(kept_.empty() ? -1 : kept_.back().time),
      file_(path) {}

void TimedTable::append(double time, std::string_view line) {
  file_.append(line);
  last_time_ = time;
}

}  // namespace sbeh::studies
