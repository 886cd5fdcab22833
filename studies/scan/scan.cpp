#include "studies/scan/scan.h"

#include "studies/io/interrupt.h"
#include "studies/io/progress.h"
#include "studies/io/results_folder.h"
#include "studies/io/stopwatch.h"
#include "studies/scan/branch_lines.h"
#include "studies/scan/branch_points.h"
#include "studies/states/profile_file.h"
#include "studies/states/series_file.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>
#include <tbb/task_group.h>

#include <algorithm>
#include <mutex>

namespace sbeh::studies {

using model::Model;

namespace {

// The folder of a scan: what is there, and how a point is kept.
class ScanFolder {
 public:
  ScanFolder(const ScanInput& input, const std::filesystem::path& path, std::string_view version)
      : folder_(path), table_(scan_table(prepare(input, version))), progress_(progress_of(input)) {}

  bool has(const PointKey& key) { return row_of(key).has_value(); }

  /// The row and state of a point that was finished before.
  std::optional<PointOutcome> finished(const PointKey& key) {
    const std::optional<PointResult> row = row_of(key);
    if (!row) return {};
    PointOutcome point{*row, {}};
    if (row->diagnostics) point.state = read_profile(profile_path(key));
    return point;
  }

  /// Keeps a point: its files first, so that a row means that they are whole.
  void keep(const PointOutcome& point) {
    if (point.state) write_profile(profile_path(point.row.key), *point.state);
    const std::lock_guard lock(mutex_);
    table_.append(point.row);
    ++computed_;
    progress_.advance();
  }

  void write(std::string_view name, const std::string& text) const {
    write_file(folder_ / name, text);
  }

  std::filesystem::path series_path(const PointKey& key) const {
    return folder_ / ("points/" + stem(key) + ".series.csv");
  }
  int computed() const { return computed_; }
  ScanTable& table() { return table_; }
  Progress& progress() { return progress_; }

 private:
  const OutputFolder& prepare(const ScanInput& input, std::string_view version) {
    begin_or_continue(folder_, describe(input, version), "scan.csv", "a scan");
    make_folder(folder_ / "points");
    if (input.beyond_fold) make_folder(folder_ / "beyond_fold");
    return folder_;
  }
  Progress progress_of(const ScanInput& input) {
    const std::vector<PointKey> keys = points_of(input);
    const auto there =
        std::count_if(keys.begin(), keys.end(), [&](const auto& k) { return has(k); });
    return Progress("points", int(keys.size()), int(there));
  }
  // None when its profile has gone: then the point counts as not computed.
  std::optional<PointResult> row_of(const PointKey& key) {
    const std::lock_guard lock(mutex_);
    const PointResult* row = table_.find(key);
    if (!row || (row->diagnostics && !std::filesystem::exists(profile_path(key)))) return {};
    return *row;
  }
  std::filesystem::path profile_path(const PointKey& key) const {
    return folder_ / ("points/" + stem(key) + ".csv");
  }

  OutputFolder folder_;
  ScanTable table_;
  std::mutex mutex_;  // before progress_, whose start asks for rows
  Progress progress_;
  int computed_ = 0;
};

// Keeps the point unless it is there; gives it either way. Empty when interrupted.
template <class Compute>
std::optional<PointOutcome> point(ScanFolder& folder, const PointKey& key, Compute&& compute) {
  if (auto there = folder.finished(key)) return there;
  if (interrupt_signal()) return {};
  PointOutcome outcome = compute();
  folder.keep(outcome);
  return outcome;
}

// SBEH at one reduced volume, along ascending L, from SSH's shape.
void scan_order_column(const ScanInput& input, ScanFolder& folder, axisym::Branch branch,
                       const Neighbour& ssh) {
  const double v = ssh.at.reduced_volume;
  std::optional<Neighbour> last;
  std::optional<PointOutcome> fold;
  for (const double L : input.L) {
    const PointKey key{v, L, Model::SBEH, branch};
    const auto outcome = point(folder, key, [&] {
      if (fold) return beyond_fold(key, *fold);
      const axisym::StationaryCase of = case_of(input, key);
      return last ? follow_to(of, *last) : order_from(of, ssh);
    });
    if (!outcome) return;
    if (outcome->row.status == PointStatus::stationary)
      last = Neighbour{{v, L}, *outcome->state};
    else if (outcome->row.status == PointStatus::unresolved && !fold)
      fold = outcome;
  }
}

// All of one reduced volume, given SSH's shape there at the first L.
void scan_column(const ScanInput& input, ScanFolder& folder, axisym::Branch branch,
                 const Neighbour& ssh) {
  if (input.has(Model::SSH))
    for (std::size_t k = 1; k < input.L.size(); ++k) {
      const PointKey key{ssh.at.reduced_volume, input.L[k], Model::SSH, branch};
      if (!point(folder, key, [&] { return rescale_to(case_of(input, key), ssh); })) return;
    }
  if (input.has(Model::SBEH)) scan_order_column(input, folder, branch, ssh);
}

// Without an SSH shape nothing of a reduced volume can be reached: all its points share the reason.
void give_up_column(const ScanInput& input, ScanFolder& folder, double v, axisym::Branch branch,
                    const PointResult& ssh) {
  for (const double L : input.L)
    for (const Model model : input.models) {
      const PointKey key{v, L, model, branch};
      point(folder, key, [&] {
        PointOutcome outcome =
            failed_point(case_of(input, key), "no SSH shape to start from: " + ssh.stop_reason);
        outcome.row.status = ssh.status;
        return outcome;
      });
    }
}

void scan_spheres(const ScanInput& input, ScanFolder& folder, axisym::Branch branch) {
  for (const double L : input.L)
    for (const Model model : input.models) {
      const PointKey key{1, L, model, branch};
      point(folder, key, [&] { return sphere_point(case_of(input, key)); });
    }
}

// Reduced volumes in the order in which the chain of SSH shapes reaches them: up from the entry, then
// down from it.
std::vector<double> chain_of(const std::vector<double>& volumes, double entry) {
  std::vector<double> chain;
  for (const double v : volumes)
    if (v > entry && v < 1) chain.push_back(v);
  for (auto v = volumes.rbegin(); v != volumes.rend(); ++v)
    if (*v <= entry) chain.push_back(*v);
  return chain;
}

// SSH's shapes along the chain; `branch_off` is called with each of them.
template <class BranchOff>
void walk_chain(const ScanInput& input, ScanFolder& folder, axisym::Branch branch,
                BranchOff&& branch_off) {
  const double L = input.L.front();
  const auto entry = enter_branch(case_of(input, {axisym::entry_volume, L, Model::SSH, branch}));
  const double entry_volume = entry ? entry->at.reduced_volume : axisym::entry_volume;
  std::optional<Neighbour> last = entry;
  bool below = false;
  for (const double v : chain_of(input.reduced_volume, entry_volume)) {
    if (interrupt_signal()) return;
    if (v <= entry_volume && !std::exchange(below, true)) last = entry;
    const PointKey key{v, L, Model::SSH, branch};
    const auto compute = [&] {
      const axisym::StationaryCase of = case_of(input, key);
      return last ? follow_to(of, *last)
                  : failed_point(of, "Newton's method failed at the entry of the branch");
    };
    const std::optional<PointOutcome> ssh =
        input.has(Model::SSH) ? point(folder, key, compute) : compute();
    if (!ssh) return;
    if (ssh->row.status != PointStatus::stationary) {
      give_up_column(input, folder, v, branch, ssh->row);
      continue;
    }
    last = Neighbour{{v, L}, *ssh->state};
    branch_off(*last);
  }
}

// One chain of SSH shapes along V_r; columns along L branch off it and run in parallel.
void scan_by_newton(const ScanInput& input, ScanFolder& folder, axisym::Branch branch) {
  tbb::task_group columns;
  columns.run([&] {
    walk_chain(input, folder, branch, [&](const Neighbour& ssh) {
      columns.run([&input, &folder, branch, ssh] { scan_column(input, folder, branch, ssh); });
    });
    if (input.reduced_volume.back() == 1) scan_spheres(input, folder, branch);
  });
  columns.wait();
}

void scan_by_flow(const ScanInput& input, ScanFolder& folder) {
  const std::vector<PointKey> keys = points_of(input);
  tbb::parallel_for(std::size_t(0), keys.size(), [&](std::size_t k) {
    if (interrupt_signal() || folder.has(keys[k])) return;
    std::vector<SeriesRow> history;
    const axisym::StationaryCase of = case_of(input, keys[k]);
    const auto outcome = of.reduced_volume == 1 ? std::optional(sphere_point(of))
                                                : flow_to_rest(of, input.flow_end_time, history);
    if (!outcome) return;
    write_file(folder.series_path(keys[k]), table_text(series_columns(), history));
    folder.keep(*outcome);
  });
}

// The lines of the diagram and the lowest branches, from the finished points; not when interrupted.
void write_lines(const ScanInput& input, ScanFolder& folder) {
  const PointLookup point = [&](const PointKey& key) { return folder.finished(key); };
  const auto write = [&](std::string_view name, const auto& columns, const auto& rows) {
    if (!interrupt_signal()) folder.write(name, table_text(columns, rows));
  };
  std::vector<axisym::RimRecord> beyond;
  if (input.has(Model::SBEH)) {
    const std::vector<FoldRow> folds = find_folds(input, point);
    write("folds.csv", fold_columns(), folds);
    if (input.beyond_fold) {
      beyond = find_beyond_fold(input, folds);
      write("beyond_fold.csv", rim_columns(), beyond);
      for (const auto& state : beyond)
        folder.write("beyond_fold/" + stem(state) + ".csv", profile_text(state.state));
    }
  }
  if (input.branches.size() > 1)
    write("equal_energy.csv", equal_energy_columns(), find_equal_energies(input, point));
  if (input.branches.size() > 1 || input.beyond_fold)
    write("lowest.csv", lowest_columns(), find_lowest(input, folder.table(), beyond));
}

}  // namespace

ScanSummary run_scan(const ScanInput& input, const std::filesystem::path& path,
                     std::string_view version) {
  const Stopwatch watch;
  ScanFolder folder(input, path, version);
  ScanSummary summary;
  if (input.method == Method::flow)
    scan_by_flow(input, folder);
  else
    for (axisym::Branch branch : input.branches) scan_by_newton(input, folder, branch);
  folder.progress().finish();
  if (input.method == Method::newton) write_lines(input, folder);
  folder.table().sort();

  for (const auto& [key, row] : folder.table().rows()) {
    ++summary.points;
    summary.stationary += row.status == PointStatus::stationary;
    summary.unresolved += row.status == PointStatus::unresolved;
    summary.failed += row.status == PointStatus::failed;
  }
  summary.computed = folder.computed();
  summary.interrupted = interrupt_signal() != 0;
  summary.seconds = watch.seconds();
  return summary;
}

}  // namespace sbeh::studies
