// `sbeh scan`: stationary shapes over a grid.
#include "studies/scan/scan_stack.h"
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

namespace {

// Measured on one core of 2026: a branch is entered at every reduced volume and followed from there in L, which SSH's
// states do not know. Lines between stable and unstable states are looked for along both.
double seconds_of(const studies::ScanInput& input) {
  if (!input.axes.empty()) {
    double seconds = 0;
    for (const studies::ScanLayer& layer : studies::layers_of(input))
      seconds += seconds_of(layer.input);
    return seconds;
  }
  if (input.method != studies::Method::newton) return 0.5 * double(studies::point_count(input));
  const auto volumes = double(input.reduced_volume.size());
  const auto branches = double(input.branches.size());
  double seconds = input.beyond_fold ? 0.75 * volumes : 0;
  for (const model::Model model : input.models) {
    const double lengths = model == model::Model::SSH ? 1 : double(input.L.size());
    seconds += branches * volumes * (0.035 + 0.004 * lengths);
    if (input.modes > 0)
      seconds +=
          branches * (0.0022 * (input.modes + 1) * volumes * lengths + 0.018 * (volumes + lengths));
  }
  return seconds;
}

}  // namespace

void check_scan(const std::string& file) {
  const studies::ScanInput input = studies::read_scan(file);
  const std::size_t points = studies::point_count(input);
  constexpr double megabytes_of_a_profile = 0.02;
  fmt::print("{}: a scan of {} points by {}, about {} of one core and {:.1f} MB\n\n{}", file,
             points, sbeh::name(input.method), duration(seconds_of(input)),
             double(points) * megabytes_of_a_profile, studies::describe(input, SBEH_VERSION));
}

}  // namespace sbeh::tools
