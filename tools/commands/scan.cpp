// `sbeh scan`: stationary shapes over a grid.
#include "studies/scan/scan.h"

#include "studies/scan/scan_cost.h"
#include "tools/commands/commands.h"

#include <algorithm>

namespace sbeh::tools {

namespace {

// Failures are told, not only tabled: the first with its reason.
int tell_failures(const studies::ScanSummary& s, const std::filesystem::path& table) {
  if (s.failed == 0) return 0;
  complain(fmt::format("{} of {} points failed, the first one because {}; all reasons are in {}",
                       s.failed, s.points, s.first_failure, table.string()));
  return 1;
}

int scan(const Study& study) {
  const studies::ScanInput input = studies::read_scan(study.input);
  const std::filesystem::path folder = study.results(), table = folder / "scan.csv";
  const studies::ScanSummary s = studies::run_scan(input, folder, SBEH_VERSION);
  fmt::print(
      "{} points in {}: {} stationary, {} unresolved, {}{} failed; {} computed in {:.2f} s\n",
      s.points, table.string(), s.stationary, s.unresolved,
      s.limit > 0 ? fmt::format("{} limit, ", s.limit) : "", s.failed, s.computed, s.seconds);
  if (s.lowest_not_found > 0)
    fmt::print("{}: at {} points a lower state must exist than those found\n",
               (folder / "lowest.csv").string(), s.lowest_not_found);
  const int ended = finish(study, studies::ResultsKind::scan, s.interrupted);
  return ended != 0 ? ended : tell_failures(s, table);
}

}  // namespace

Command add_scan(CLI::App& program) {
  return add_study(program, studies::InputKind::scan, "stationary shapes over a (V_r, L) grid",
                   scan);
}

void check_scan(const std::string& file) {
  const studies::ScanInput input = studies::read_scan(file);
  const std::size_t points = studies::point_count(input);
  constexpr double megabytes_of_a_profile = 0.02;
  fmt::print("{}: a scan of {} points by {}, about {} of one core and {:.1f} MB\n\n{}", file,
             points, sbeh::name(input.method), duration(seconds_of(input)),
             double(points) * megabytes_of_a_profile, studies::describe(input, SBEH_VERSION));
}

}  // namespace sbeh::tools
