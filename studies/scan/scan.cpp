#include "studies/scan/scan.h"

#include "studies/io/description.h"
#include "studies/io/interrupt.h"
#include "studies/io/output.h"
#include "studies/io/progress.h"
#include "studies/io/stopwatch.h"
#include "studies/scan/beyond_fold.h"
#include "studies/scan/branch_lines.h"
#include "studies/scan/branch_points.h"
#include "studies/scan/lowest.h"
#include "studies/scan/scan_stack.h"
#include "studies/scan/stability_lines.h"
#include "studies/states/profile_file.h"
#include "studies/states/series_file.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>
#include <tbb/task_group.h>

#include <algorithm>
#include <mutex>

namespace sbeh::studies {

namespace fs = std::filesystem;
using axisym::Branch;
using axisym::StationaryCase;
using model::Model;

namespace {

bool has_profile(const PointResult& row) {
  return row.diagnostics && row.status != PointStatus::limit;
}

// A scan in its folder: what is there, and how a point is kept.
struct Scan {
  Scan(const ScanInput& of, const fs::path& path, std::string_view version, const Part& some = {})
      : input(of),
        part(some),
        folder(path),
        table(scan_table(prepare(version))),
        progress(begun(version)) {}

  /// Whether the points of a reduced volume belong to its part.
  bool takes(double reduced_volume) const {
    const auto& all = input.reduced_volume;
    return part.has(1 + int(std::ranges::find(all, reduced_volume) - all.begin()));
  }
  bool has(const PointKey& key) { return row_of(key) != nullptr; }

  /// The row and state of a point that was finished before.
  std::optional<PointOutcome> finished(const PointKey& key) {
    const PointResult* row = row_of(key);
    if (!row) return {};
    PointOutcome point{*row, {}};
    if (has_profile(*row))
      point.state = axisym::StationaryState{read_profile(point_file(folder.path(), key, ".csv"))};
    return point;
  }

  /// Keeps a point: its files first, so that a row means that they are whole.
  void keep(const PointKey& key, PointOutcome& point) {
    point.row.key = key;
    if (input.modes > 0) add_modes(case_of(input, key), input.modes, point);
    if (point.state) {
      auto z = point.state->X.row(1).array();
      z -= (z.maxCoeff() + z.minCoeff()) / 2;  // in what goes on from here too
      write_profile(point_file(folder.path(), key, ".csv"), *point.state);
    }
    const std::lock_guard lock(mutex);
    table.append(point.row);
    ++computed;
    progress.advance();
  }

  /// Computes the point from its case and keeps it, unless it is there; gives it either way. Empty when
  /// interrupted.
  template <class Compute>
  std::optional<PointOutcome> point(const PointKey& key, Compute&& compute) {
    if (auto there = finished(key)) return there;
    if (interrupt_signal()) return {};
    PointOutcome outcome = compute(case_of(input, key));
    keep(key, outcome);
    return outcome;
  }

  const ScanInput& input;
  const Part part;
  const OutputFolder folder;
  ScanTable table;
  std::mutex mutex;  ///< of the table; before progress, whose start asks for rows
  Progress progress;
  int computed = 0;

 private:
  const OutputFolder& prepare(std::string_view version) const {
    begin_or_continue(folder, describe(input, version), "scan.csv", "a scan");
    make_folder(folder / "points");
    if (input.beyond_fold) make_folder(folder / "beyond_fold");
    return folder;
  }
  Progress begun(std::string_view version) {
    take_parts(version);
    std::vector<PointKey> keys = points_of(input);
    std::erase_if(keys, [&](const PointKey& key) { return !takes(key.reduced_volume); });
    const auto there = std::ranges::count_if(keys, [&](const auto& key) { return has(key); });
    return Progress("points", int(keys.size()), int(there));
  }
  // Takes the points over that parts have computed: the files of each first.
  void take_parts(std::string_view version) {
    if (!fs::exists(folder / "parts")) return;
    for (const auto& entry : fs::directory_iterator(folder / "parts")) {
      const fs::path rows = entry.path() / "scan.csv";
      if (!fs::exists(rows)) continue;
      if (const std::string other = studies::mismatch(read_file(entry.path() / "run.toml"),
                                                      describe(input, version), "a part of a scan");
          !other.empty())
        throw OutputError(fmt::format("{}: {}; move it away", entry.path().string(), other));
      for (const PointResult& row : read_rows(scan_columns(), rows)) {
        if (has(row.key)) continue;
        for (const char* ending : {".csv", ".series.csv"})
          if (const fs::path file = point_file(entry.path(), row.key, ending); fs::exists(file))
            write_file(point_file(folder.path(), row.key, ending), read_file(file));
        table.append(row);
      }
    }
  }
  // None when its profile has gone: then the point counts as not computed.
  const PointResult* row_of(const PointKey& key) {
    const std::lock_guard lock(mutex);
    const PointResult* row = table.find(key);
    return row && has_profile(*row) && !fs::exists(point_file(folder.path(), key, ".csv")) ? nullptr
                                                                                           : row;
  }
};

// SBEH at one reduced volume, along ascending L, from SSH's shape.
void scan_order_column(Scan& scan, Branch branch, const Neighbour& ssh) {
  const double v = ssh.at.reduced_volume;
  std::optional<Neighbour> last;
  std::optional<PointOutcome> fold;  // beyond it its row and state stand under each L
  for (const double L : scan.input.L) {
    const PointKey key{v, L, Model::SBEH, branch};
    const auto outcome = scan.point(key, [&](const StationaryCase& of) {
      if (fold) return *fold;
      if (last) return follow_to(of, *last);
      const bool is_its_own = L == ssh.at.L || !of.material.has_given();  // SSH's shape
      return is_its_own ? order_from(of, ssh.state) : branch_point(of);
    });
    if (!outcome) return;
    if (has_state_here(*outcome)) {
      last = Neighbour{{v, L}, *outcome->state};
    } else if (outcome->row.fold_side == "at" && !fold) {
      fold = outcome;
      fold->row.wall_seconds = 0;
    }
  }
}

// All of one reduced volume, given SSH's shape there at the first L.
void scan_column(Scan& scan, Branch branch, const Neighbour& ssh) {
  const auto rescaled = [&](const StationaryCase& of) { return rescale_to(of, ssh); };
  if (scan.input.has(Model::SSH))
    for (std::size_t k = 1; k < scan.input.L.size(); ++k)
      if (!scan.point({ssh.at.reduced_volume, scan.input.L[k], Model::SSH, branch}, rescaled))
        return;
  if (scan.input.has(Model::SBEH)) scan_order_column(scan, branch, ssh);
}

// All points of one reduced volume, each for itself.
template <class Compute>
void scan_all_of(Scan& scan, double v, Branch branch, Compute&& compute) {
  for (const double L : scan.input.L)
    for (const Model model : scan.input.models) scan.point({v, L, model, branch}, compute);
}

// SSH's shapes at the first L, from the highest reduced volume down; `branch_off` is called with each of them.
template <class BranchOff>
void walk_volumes(Scan& scan, Branch branch, BranchOff&& branch_off) {
  const double L = scan.input.L.front();
  axisym::SshBranch states(branch, scan.input.material.with_L1(L), scan.input.numerics);
  const auto compute = [&](const StationaryCase& of) { return ssh_point(of, states); };
  const std::vector<double> from_above(scan.input.reduced_volume.rbegin(),
                                       scan.input.reduced_volume.rend());
  for (const double v : from_above) {
    if (interrupt_signal()) return;
    if (v == 1 || !scan.takes(v)) continue;
    const PointKey key{v, L, Model::SSH, branch};
    const std::optional<PointOutcome> ssh =
        scan.input.has(Model::SSH) ? scan.point(key, compute) : compute(case_of(scan.input, key));
    if (!ssh) return;
    if (has_state_here(*ssh)) {
      branch_off(Neighbour{{v, L}, *ssh->state});
      continue;
    }
    // Without it nothing of this reduced volume can be reached: all its points share the reason.
    scan_all_of(scan, v, branch, [&](const StationaryCase& of) {
      return scan.input.material.has_given() ? branch_point(of)  // SSH's shape is another at each L
                                             : without_ssh(of, *ssh, L);
    });
  }
}

// Of each branch SSH's shapes one after the other; columns along L branch off them and run in parallel.
void scan_by_newton(Scan& scan) {
  tbb::task_group columns;
  for (const Branch branch : scan.input.branches)
    columns.run([&scan, &columns, branch] {
      walk_volumes(scan, branch, [&](const Neighbour& ssh) {
        columns.run([&scan, branch, ssh] { scan_column(scan, branch, ssh); });
      });
      if (scan.input.reduced_volume.back() == 1 && scan.takes(1))
        scan_all_of(scan, 1, branch, sphere_point);
    });
  columns.wait();
}

void scan_by_flow(Scan& scan) {
  const std::vector<PointKey> keys = points_of(scan.input);
  tbb::parallel_for(std::size_t(0), keys.size(), [&](std::size_t k) {
    if (interrupt_signal() || !scan.takes(keys[k].reduced_volume) || scan.has(keys[k])) return;
    std::vector<SeriesRow> history;
    const StationaryCase of = case_of(scan.input, keys[k]);
    auto outcome = of.reduced_volume == 1 ? std::optional(sphere_point(of))
                                          : flow_to_rest(of, scan.input.flow_end_time, history);
    if (!outcome) return;
    write_file(point_file(scan.folder.path(), keys[k], ".series.csv"),
               table_text(series_columns(), history));
    scan.keep(keys[k], *outcome);
  });
}

// The L of the fold ahead, in the rows of a branch before it.
void fill_fold_L(ScanTable& table, const std::vector<FoldRow>& folds) {
  std::vector<PointResult> filled;
  for (const auto& [key, row] : table.rows())
    if (key.model == Model::SBEH && row.fold_side == "before")
      for (const FoldRow& fold : folds)
        if (fold.branch == key.branch && fold.reduced_volume == key.reduced_volume
            && row.fold_L != fold.L) {
          filled.push_back(row);
          filled.back().fold_L = fold.L;
          filled.back().fold_L_error = fold.L_error;
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
    if (!interrupt_signal()) fill_fold_L(scan.table, folds);
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

void compute_points(Scan& scan) {
  if (scan.input.method == Method::flow)
    scan_by_flow(scan);
  else
    scan_by_newton(scan);
  scan.progress.finish();
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
