#include "studies/scan/stability_lines.h"

#include "axisym/modes/threshold.h"
#include "axisym/stationary/symmetry.h"
#include "studies/scan/collect.h"

#include <fmt/format.h>

#include <numeric>

namespace sbeh::studies {

using axisym::Branch;
using model::Model;

namespace {

constexpr double few_lines = 1e-9;  // the error where lines are solved for once for all L

// Neighbours: a state, and one on whose side lines of these m are looked for.
struct Stretch {
  PointKey from, to;
  Along along;
  std::vector<int> ms;
};

bool is_state(const PointResult& row) {
  return row.status == PointStatus::stationary && row.fold_side == "before";
}

// Those that are unstable on either side, where the sides differ or are not known.
std::vector<int> changing(const axisym::Stability3d& a, const axisym::Stability3d& b) {
  std::vector<int> ms;
  if (a.negative_directions && a.negative_directions == b.negative_directions
      && a.unstable == b.unstable)
    return ms;
  for (std::size_t m = 0; m < a.eigenvalue.size(); ++m)
    if (a.eigenvalue[m] < 0 || b.eigenvalue[m] < 0) ms.push_back(int(m));
  return ms;
}

class Stretches {
 public:
  Stretches(const ScanTable& table, int largest_m)
      : table_(table), all_ms_(std::size_t(largest_m) + 1) {
    std::iota(all_ms_.begin(), all_ms_.end(), 0);
  }

  void add(const PointKey& a, const PointKey& b, Along along) {
    const PointResult *first = table_.find(a), *second = table_.find(b);
    if (!first || !second) return;
    if (is_state(*first) && is_state(*second)) {
      if (auto ms = changing(first->modes, second->modes); !ms.empty())
        all.push_back({a, b, along, std::move(ms)});
    } else if (is_state(*first) && second->fold_side == "at") {
      all.push_back({a, b, along, all_ms_});
    } else if (is_state(*second) && first->fold_side == "at") {
      all.push_back({b, a, along, all_ms_});
    }
  }

  std::vector<Stretch> all;

 private:
  const ScanTable& table_;
  std::vector<int> all_ms_;
};

std::vector<Stretch> stretches_of(const ScanInput& input, const ScanTable& table) {
  Stretches stretches(table, input.modes);
  const auto &volumes = input.reduced_volume, &lengths = input.L;
  for (const Model model : input.models)
    for (const Branch branch : input.branches) {
      const std::size_t rows = model == Model::SSH ? 1 : lengths.size();
      for (std::size_t j = 0; j < rows; ++j)
        for (std::size_t i = 1; i < volumes.size(); ++i)
          stretches.add({volumes[i - 1], lengths[j], model, branch},
                        {volumes[i], lengths[j], model, branch}, Along::reduced_volume);
      if (model == Model::SSH) continue;
      for (const double v : volumes)
        for (std::size_t j = 1; j < lengths.size(); ++j)
          stretches.add({v, lengths[j - 1], model, branch}, {v, lengths[j], model, branch},
                        Along::L);
    }
  return stretches.all;
}

StabilityLineRow row_of(const Stretch& on, const axisym::Threshold& threshold) {
  StabilityLineRow row{on.from.model, on.from.branch, threshold.m, threshold.parity, on.along};
  const auto& [volume, L] = threshold.state.at;
  const bool in_volume = on.along == Along::reduced_volume;
  (in_volume ? row.L : row.reduced_volume) = in_volume ? on.from.L : on.from.reduced_volume;
  if (threshold.is_located) {
    (in_volume ? row.reduced_volume : row.L) = in_volume ? volume : L;
    row.error = threshold.error;
    return row;
  }
  row.reason = fmt::format("near {} = {:.4g}: {}", sbeh::name(on.along), in_volume ? volume : L,
                           std::isinf(threshold.error)
                               ? "the branch is lost on the way"
                               : fmt::format("the error is still {:.1e}", threshold.error));
  return row;
}

std::vector<StabilityLineRow> rows_on(const ScanInput& input, const Stretch& stretch,
                                      const PointLookup& point) {
  const auto outcome = point(stretch.from);
  const auto start = outcome && outcome->state
                       ? settled(case_of(input, stretch.from), *outcome->state)
                       : std::nullopt;
  if (!start) return {};
  axisym::Line line{
      input.material, stretch.from.model, start->at, {stretch.to.reduced_volume, stretch.to.L}};
  line.symmetric = axisym::is_symmetric(start->X);
  const double promised = line.model == Model::SSH ? few_lines : axisym::promised_threshold;
  std::vector<StabilityLineRow> rows;
  for (const axisym::Threshold& threshold :
       axisym::thresholds_along(line, *start, stretch.ms, input.numerics, promised))
    rows.push_back(row_of(stretch, threshold));
  return rows;
}

}  // namespace

std::vector<StabilityLineRow> find_stability_lines(const ScanInput& input, const ScanTable& table,
                                                   const PointLookup& point) {
  const std::vector<Stretch> stretches = stretches_of(input, table);
  const auto found = collect<StabilityLineRow>(
      stretches.size(), [&](std::size_t k) { return rows_on(input, stretches[k], point); });
  std::vector<StabilityLineRow> rows;
  for (const StabilityLineRow& row : found) {
    rows.push_back(row);
    if (row.model == Model::SSH)
      for (std::size_t j = 1; j < input.L.size(); ++j) rows.emplace_back(row).L = input.L[j];
  }
  return rows;
}

const Columns<StabilityLineRow>& stability_line_columns() {
  using Row = StabilityLineRow;
  static const Columns<Row> columns{
      column("model", &Row::model),   column("branch", &Row::branch),
      column("m", &Row::m),           column("parity", &Row::parity),
      column("along", &Row::along),   known_column("reduced_volume", &Row::reduced_volume),
      known_column("L", &Row::L),     known_column("error", &Row::error, "{:.2g}"),
      column("reason", &Row::reason),
  };
  return columns;
}

}  // namespace sbeh::studies
