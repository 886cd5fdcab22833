#include "studies/io/timed_table.h"

#include "studies/io/csv.h"
#include "studies/io/output.h"

#include <sstream>

namespace sbeh::studies {

namespace {

// Writes the table anew with the rows up to a time, which it returns.
std::vector<TimedRow> keep_until(const std::filesystem::path& path, const std::string& header,
                                 std::size_t time_column, double time) {
  std::vector<TimedRow> rows = timed_rows(path, time_column);
  std::erase_if(rows, [&](const TimedRow& row) { return !(row.time <= time); });
  std::string text = header + "\n";
  for (const TimedRow& row : rows) text += row.line + "\n";
  write_file(path, text);
  return rows;
}

}  // namespace

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

TimedTable::TimedTable(const std::filesystem::path& path, const std::string& header,
                       std::size_t time_column, double until)
    : kept_(keep_until(path, header, time_column, until)),
      last_time_(kept_.empty() ? -1 : kept_.back().time),
      file_(path) {}

void TimedTable::append(double time, std::string_view line) {
  file_.append(line);
  last_time_ = time;
}

}  // namespace sbeh::studies
