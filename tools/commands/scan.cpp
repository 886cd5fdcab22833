// `sbeh scan`: stationary shapes over a grid.
#include "studies/scan/scan.h"

#include "tools/commands/commands.h"

#include <algorithm>

namespace sbeh::tools {

namespace {

int scan(const Study& study) {
  const studies::ScanInput input = studies::read_scan(study.input);
  const std::filesystem::path folder = study.results();
  const studies::ScanSummary s = studies::run_scan(input, folder, SBEH_VERSION);
  fmt::print("{} points in {}: {} stationary, {} unresolved, {} failed; {} computed in {:.2f} s\n",
             s.points, (folder / "scan.csv").string(), s.stationary, s.unresolved, s.failed,
             s.computed, s.seconds);
  if (s.lowest_not_found > 0)
    fmt::print("{}: at {} points a lower state must exist than those found\n",
               (folder / "lowest.csv").string(), s.lowest_not_found);
  return finish(study, studies::ResultsKind::scan, s.interrupted);
}

}  // namespace

Command add_scan(CLI::App& program) {
  return add_study(program, "scan", "stationary shapes over a (V_r, L) grid", scan);
}

void check_scan(const std::string& file) {
  const studies::ScanInput input = studies::read_scan(file);
  const std::size_t points = studies::point_count(input);
  // About 10 ms a point by Newton, 1 s by the flow, on one core of 2026; 20 kB a profile.
  const double seconds = double(points) * (input.method == studies::Method::newton ? 0.01 : 1);
  fmt::print("{}: a scan of {} points by {}, about {:.0f} s of one core and {:.1f} MB\n\n{}", file,
             points, sbeh::name(input.method), std::max(1., seconds), double(points) * 0.02,
             studies::describe(input, SBEH_VERSION));
}

}  // namespace sbeh::tools
