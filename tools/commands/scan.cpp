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

void print_points(const studies::ScanSummary& s, const std::filesystem::path& table) {
  fmt::print(
      "{} points in {}: {} stationary, {} unresolved, {}{} failed; {} computed in {:.2f} s\n",
      s.points, table.string(), s.stationary, s.unresolved,
      s.limit > 0 ? fmt::format("{} limit, ", s.limit) : "", s.failed, s.computed, s.seconds);
}

int scan(const Study& study) {
  const studies::ScanInput input = studies::read_scan(study.input);
  const std::filesystem::path folder = study.results(), table = folder / "scan.csv";
  const studies::ScanSummary s = studies::run_scan(input, folder, SBEH_VERSION);
  print_points(s, table);
  if (s.lowest_not_found > 0)
    fmt::print("{}: at {} points a lower state must exist than those found\n",
               (folder / "lowest.csv").string(), s.lowest_not_found);
  const int ended = finish(study, studies::ResultsKind::scan, s.interrupted);
  return ended != 0 ? ended : tell_failures(s, table);
}

// Without what is made of all parts: lines and pictures. Whether points failed is told with them.
int scan_part(const Study& study, const studies::Part& part) {
  const std::filesystem::path folder = study.results();
  const studies::ScanSummary s =
      studies::run_scan_part(studies::read_scan(study.input), folder, part, SBEH_VERSION);
  print_points(s, studies::part_folder(folder, part));
  if (s.interrupted) {
    complain("interrupted; the same command goes on from here");
    return exit_code_of_interrupt();
  }
  fmt::print("when all parts are there: sbeh scan {} -o {}\n", study.input, folder.string());
  return exit_code_of_success();
}

}  // namespace

Command add_scan(CLI::App& program) {
  const auto part = std::make_shared<std::string>();
  Command command =
      add_study(program, studies::InputKind::scan, "stationary shapes over a (V_r, L) grid",
                [part](const Study& study) {
                  return part->empty() ? scan(study) : scan_part(study, part_of(*part));
                });
  command.app->add_option("--part", *part,
                          "only every N-th reduced volume from the K-th on, K/N; without it the "
                          "parts that are there are put together");
  return command;
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
