#include "studies/report/live_data.h"

#include "studies/io/csv.h"
#include "studies/io/output.h"

#include <fmt/format.h>

namespace sbeh::studies {

namespace {

constexpr std::size_t most_points = 20'000;  // of a scan: then the page has 20 MB

}  // namespace

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

std::string too_many_for_a_page(const std::filesystem::path& folder, ResultsKind kind) {
  if (kind != ResultsKind::scan) return "";
  const std::size_t points = read_csv(folder / "scan.csv").rows.size();
  return points <= most_points ? "" : fmt::format("{} points, {} at most", points, most_points);
}

}  // namespace sbeh::studies
