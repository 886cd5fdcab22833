#include "studies/report/live_data.h"

#include "studies/io/output.h"

namespace sbeh::studies {

std::string whole_lines(const std::filesystem::path& file) {
  const std::string text = read_file(file);
  return text.substr(0, text.rfind('\n') + 1);
}

bool has_live_page(ResultsKind kind) {
  return kind == ResultsKind::scan || kind == ResultsKind::run || kind == ResultsKind::relax;
}

Bundle live_data(const std::filesystem::path& folder, ResultsKind kind) {
  if (kind == ResultsKind::scan) return live_scan(folder);
  return kind == ResultsKind::run ? live_run(folder) : live_relax(folder);
}

}  // namespace sbeh::studies
