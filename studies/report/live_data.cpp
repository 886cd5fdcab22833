#include "studies/report/live_data.h"

#include "studies/io/output.h"

namespace sbeh::studies {

std::string whole_lines(const std::filesystem::path& file) {
  const std::string text = read_file(file);
  return text.substr(0, text.rfind('\n') + 1);
}

Bundle live_data(const std::filesystem::path& folder, ResultsKind kind) {
  switch (kind) {
    case ResultsKind::scan:
      return live_scan(folder);
    case ResultsKind::run:
      return live_run(folder);
    case ResultsKind::relax:
      return live_relax(folder);
    case ResultsKind::modes:
      return live_modes(folder);
    default:
      return {};
  }
}

bool has_live_page(ResultsKind kind) {
  using enum ResultsKind;
  return kind == scan || kind == run || kind == relax || kind == modes;
}

}  // namespace sbeh::studies
