#include "studies/scan/scan_walks.h"

#include "studies/io/interrupt.h"
#include "studies/io/output.h"
#include "studies/scan/domain_start.h"
#include "studies/scan/traced_states.h"
#include "studies/states/series_file.h"

#include <tbb/parallel_for.h>
#include <tbb/task_group.h>

#include <algorithm>

namespace sbeh::studies {

using axisym::Branch;
using axisym::StationaryCase;
using model::Model;

namespace {

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
  const model::Material material = scan.input.material.with_L1(L);
  axisym::SshBranch states(branch, material, scan.input.numerics);
  std::optional<TracedStates> traced;
  if (branch == Branch::pear) traced.emplace(material, scan.input.numerics);
  const auto compute = [&](const StationaryCase& of) {
    return traced ? traced->point(of) : ssh_point(of, states);
  };
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

// States with domains along keys from the first on, which has a state of its own; beyond a fold its row stands under each key.
template <class Visit>
void walk_on(Scan& scan, const PointOutcome& first, const std::vector<PointKey>& keys,
             Visit&& visit) {
  Neighbour last{{keys[0].reduced_volume, keys[0].L}, *first.state};
  std::optional<PointOutcome> end;
  for (std::size_t k = 1; k < keys.size(); ++k) {
    const auto outcome = scan.passed(
        keys[k], [&](const StationaryCase& of) { return end ? *end : follow_to(of, last); });
    if (!outcome) return;
    if (has_state_here(*outcome)) last = {{keys[k].reduced_volume, keys[k].L}, *outcome->state};
    if (outcome->row.fold_side == "at" && !end) {
      end = outcome;
      end->row.wall_seconds = 0;
    }
    visit(keys[k], *outcome);
  }
}

// States with domains of a branch: from its beginning at the highest reduced volume along L, and from each of these down in
// parallel. What does not reach the highest reduced volume is not looked for below it.
void scan_domains(Scan& scan, Branch branch, tbb::task_group& tasks) {
  const auto& volumes = scan.input.reduced_volume;
  std::vector<PointKey> along_L;
  for (const double L : scan.input.L) along_L.push_back({volumes.back(), L, Model::SBEH, branch});
  const auto down_from = [&scan, &tasks, &volumes, branch](const PointKey& top,
                                                           const PointOutcome& state) {
    std::vector<PointKey> keys;
    for (auto v = volumes.rbegin(); v != volumes.rend(); ++v)
      keys.push_back({*v, top.L, Model::SBEH, branch});
    if (has_state_here(state)) {
      tasks.run([&scan, keys, state] { walk_on(scan, state, keys, [](const auto&...) {}); });
      return;
    }
    for (std::size_t k = 1; k < keys.size(); ++k)
      scan.passed(keys[k], [&](const StationaryCase&) {
        return failed_point("no state with domains to come from: " + state.row.stop_reason);
      });
  };
  const auto first = scan.passed(
      along_L[0], [&](const StationaryCase& of) { return point_with(of, scan.input.start_order); });
  if (!first) return;
  down_from(along_L[0], *first);
  if (has_state_here(*first)) {
    walk_on(scan, *first, along_L, down_from);
    return;
  }
  for (std::size_t k = 1; k < along_L.size(); ++k) {
    scan.passed(along_L[k], [&](const StationaryCase&) {
      return failed_point("the branch does not begin: " + first->row.stop_reason);
    });
    down_from(along_L[k], *first);
  }
}

// Of each branch SSH's shapes one after the other; columns along L branch off them and run in parallel.
void scan_by_newton(Scan& scan) {
  tbb::task_group columns;
  for (const Branch branch : scan.input.branches)
    columns.run([&scan, &columns, branch] {
      if (scan.input.interfaces > 0) {
        scan_domains(scan, branch, columns);
        return;
      }
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

}  // namespace

void compute_points(Scan& scan) {
  if (scan.input.method == Method::flow)
    scan_by_flow(scan);
  else
    scan_by_newton(scan);
  scan.progress.finish();
}

}  // namespace sbeh::studies
