#include "studies/scan/scan.h"

#include "studies/io/interrupt.h"
#include "studies/io/output.h"
#include "studies/io/stopwatch.h"
#include "studies/scan/beyond_fold.h"
#include "studies/scan/branch_lines.h"
#include "studies/scan/further_states.h"
#include "studies/scan/lowest.h"
#include "studies/scan/scan_stack.h"
#include "studies/scan/scan_walks.h"
#include "studies/scan/stability_lines.h"

#include <fmt/format.h>

#include <algorithm>

namespace sbeh::studies {

namespace fs = std::filesystem;
using model::Model;

namespace {

// The fold ahead on the ways along L and along V_r, in the rows of a branch before it.
void fill_folds(ScanTable& table, const std::vector<FoldRow>& folds) {
  std::vector<PointResult> filled;
  for (const auto& [key, row] : table.rows()) {
    if (key.model != Model::SBEH || row.fold_side != "before") continue;
    PointResult with = row;
    for (const FoldRow& fold : folds) {
      if (fold.branch != key.branch) continue;
      if (is_along_volume(fold) && fold.L == key.L) {
        with.fold_reduced_volume = fold.reduced_volume;
        with.fold_reduced_volume_error = fold.reduced_volume_error;
      } else if (!is_along_volume(fold) && fold.reduced_volume == key.reduced_volume) {
        with.fold_L = fold.L;
        with.fold_L_error = fold.L_error;
      }
    }
    if (with.fold_L != row.fold_L || with.fold_reduced_volume != row.fold_reduced_volume)
      filled.push_back(with);
  }
  for (const PointResult& row : filled) table.append(row);
}

// The lines of the diagram and the lowest branches, from the finished points; not when interrupted.
// Gives the number of points at which the lowest state is not found.
int write_lines(Scan& scan) {
  const ScanInput& input = scan.input;
  const PointLookup point = [&](const PointKey& key) { return scan.finished(key); };
  const auto write = [&](std::string_view name, const auto& columns, const auto& rows) {
    if (!interrupt_signal()) write_file(scan.folder / name, table_text(columns, rows));
  };
  std::vector<RimRow> beyond;
  if (input.has(Model::SBEH)) {
    const std::vector<FoldRow> folds = find_folds(input, point);
    write("folds.csv", fold_columns(), folds);
    if (!interrupt_signal()) fill_folds(scan.table, folds);
    if (input.beyond_fold) {
      beyond = find_beyond_fold(input, folds);
      write("beyond_fold.csv", rim_columns(), beyond);
      for (const auto& state : beyond)
        write_file(scan.folder / ("beyond_fold/" + stem(state) + ".csv"),
                   profile_text(state.state));
    }
  }
  if (input.modes > 0)
    write("stability_lines.csv", stability_line_columns(),
          find_stability_lines(input, scan.table, point));
  if (input.branches.size() > 1)
    write("equal_energy.csv", equal_energy_columns(), find_equal_energies(input, point));
  if (input.further && !interrupt_signal())
    write("further.csv", further_columns(), find_further(input, scan.table, scan.folder.path()));
  if (input.branches.size() < 2 && !input.beyond_fold) return 0;
  const std::vector<LowestRow> lowest = find_lowest(input, scan.table, beyond);
  write("lowest.csv", lowest_columns(), lowest);
  return int(std::ranges::count(lowest, not_found, &LowestRow::branch));
}

ScanSummary summary_of(const Scan& scan) {
  ScanSummary summary;
  for (const auto& [key, row] : scan.table.rows()) {
    ++summary.points;
    summary.stationary += row.status == PointStatus::stationary;
    summary.unresolved += row.status == PointStatus::unresolved;
    summary.limit += row.status == PointStatus::limit;
    if (row.status == PointStatus::failed && summary.failed++ == 0)
      summary.first_failure = row.stop_reason;
  }
  summary.computed = scan.computed;
  summary.interrupted = interrupt_signal() != 0;
  return summary;
}

}  // namespace

ScanSummary run_scan(const ScanInput& input, const fs::path& path, std::string_view version) {
  if (!input.axes.empty()) return run_stack(input, path, version);
  const Stopwatch watch;
  Scan scan(input, path, version);
  compute_points(scan);
  const int lowest_not_found = input.method == Method::newton ? write_lines(scan) : 0;
  scan.table.sort();
  ScanSummary summary = summary_of(scan);
  summary.lowest_not_found = lowest_not_found;
  summary.seconds = watch.seconds();
  return summary;
}

ScanSummary run_scan_part(const ScanInput& input, const fs::path& path, const Part& part,
                          std::string_view version) {
  if (!input.axes.empty()) return run_stack_part(input, path, part, version);
  const Stopwatch watch;
  Scan scan(input, part_folder(path, part), version, part);
  compute_points(scan);
  scan.table.sort();
  ScanSummary summary = summary_of(scan);
  summary.seconds = watch.seconds();
  return summary;
}

fs::path part_folder(const fs::path& folder, const Part& part) {
  return folder / "parts" / fmt::format("{}_of_{}", part.part, part.parts);
}

}  // namespace sbeh::studies
