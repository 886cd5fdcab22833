#include "studies/report/live_data.h"

#include "studies/io/csv.h"
#include "studies/io/output.h"
#include "studies/scan/scan_input.h"

#include <fmt/format.h>

namespace sbeh::studies {

namespace {

constexpr std::size_t most_points = 20'000;  // of a scan: then the page has 20 MB

}  // namespace

std::string whole_lines(const std::filesystem::path& file) {
  const std::string text = read_file(file);
  return text.substr(0, text.rfind('\n') + 1);
}

void add_table(Bundle& bundle, const std::filesystem::path& folder, const std::string& name,
               const std::optional<ResultUnits>& units) {
  bundle.add(name, units ? text_of(units->values(read_csv(folder / name), name))
                         : whole_lines(folder / name));
}

void add_units(Bundle& bundle, const std::optional<ResultUnits>& units,
               const std::vector<std::string>& columns) {
  if (!units) return;
  std::string table = "name,unit,factor\n";
  const auto add = [&](std::string_view name, const Dimension& d) {
    const bool by_row = units->by_L() && (d.energy != 0 || d.time != 0);
    if (d != dimension::none)
      table += fmt::format("{},{},{}\n", name, units->unit(d),
                           by_row ? "" : fmt::format("{}", units->scales().factor(d)));
  };
  for (const std::string& column : columns) add(column, *dimension_of(column));
  add("H", dimension::curvature);
  add("speed", dimension::speed);
  bundle.add("units.csv", table);
}

Bundle live_data(const std::filesystem::path& folder, ResultsKind kind,
                 const std::optional<ResultUnits>& units) {
  switch (kind) {
    case ResultsKind::scan:
      return live_scan(folder, units);
    case ResultsKind::run:
      return live_run(folder, units);
    case ResultsKind::relax:
      return live_relax(folder, units);
    case ResultsKind::modes:
      return live_modes(folder, units);
    case ResultsKind::states:
      return live_states(folder, units);
    default:
      return {};
  }
}

bool has_live_page(ResultsKind kind) {
  using enum ResultsKind;
  return kind == scan || kind == run || kind == relax || kind == modes || kind == states;
}

std::string too_many_for_a_page(const std::filesystem::path& folder, ResultsKind kind) {
  if (kind != ResultsKind::scan) return "";
  if (!read_scan(folder / "run.toml").axes.empty()) return "further axes: its layers have pages";
  const std::size_t points = read_csv(folder / "scan.csv").rows.size();
  return points <= most_points ? "" : fmt::format("{} points, {} at most", points, most_points);
}

}  // namespace sbeh::studies
