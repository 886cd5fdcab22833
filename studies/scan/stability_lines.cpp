#include "studies/scan/stability_lines.h"

#include "axisym/modes/threshold.h"
#include "axisym/stationary/symmetry.h"
#include "studies/scan/collect.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
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
  axisym::Search search = axisym::Search::changes;
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

// The least that a function may be between x_1 and x_2, where its values have one sign, which is made positive: as long as
// it bends one way only it cannot pass the secants through the first and the last two of the four points. Those that are
// not known are nan.
double least_between(const std::array<double, 4>& x, const std::array<double, 4>& values) {
  const double sign = values[1] < 0 ? -1 : 1;
  const auto secant = [&](std::size_t k, double at) {
    const double slope = (values[k + 1] - values[k]) / (x[k + 1] - x[k]);
    return sign * (values[k] + slope * (at - x[k]));
  };
  if (std::isnan(values[0]) && std::isnan(values[3])) return sign * values[1];
  if (std::isnan(values[0])) return secant(2, x[1]);
  if (std::isnan(values[3])) return secant(0, x[2]);
  const double left = secant(0, x[1]) - secant(2, x[1]), right = secant(0, x[2]) - secant(2, x[2]);
  if (left <= 0 || right >= 0) return sign * values[1];  // they do not meet there
  return secant(0, x[1] + (x[2] - x[1]) * left / (left - right));
}

// Of four rows in a line the ms whose eigenvalue has one sign in the second and the third, and may have the other between
// them. Over L, with which all stiffnesses go.
std::vector<int> turning(const std::array<const PointResult*, 4>& rows, Along along) {
  std::vector<int> ms;
  for (std::size_t m = 0; m < rows[1]->modes.eigenvalue.size(); ++m) {
    std::array<double, 4> x{}, values{};
    values.fill(not_known);
    for (std::size_t k = 0; k < rows.size(); ++k) {
      if (!rows[k]) continue;
      const PointKey& key = rows[k]->key;
      x[k] = along == Along::L ? key.L : key.reduced_volume;
      values[k] = rows[k]->modes.eigenvalue[m] / key.L;
    }
    if (values[1] * values[2] > 0 && least_between(x, values) < 0) ms.push_back(int(m));
  }
  return ms;
}

class Stretches {
 public:
  Stretches(const ScanTable& table, int largest_m)
      : table_(table), all_ms_(std::size_t(largest_m) + 1) {
    std::iota(all_ms_.begin(), all_ms_.end(), 0);
  }

  // Those between neighbours of a line of the scan.
  void add(const std::vector<PointKey>& keys, Along along) {
    std::vector<const PointResult*> rows{nullptr};
    for (const PointKey& key : keys) rows.push_back(table_.find(key));
    rows.push_back(nullptr);
    for (std::size_t k = 2; k + 1 < rows.size(); ++k)
      if (rows[k - 1] && rows[k])
        add({state(rows[k - 2]), rows[k - 1], rows[k], state(rows[k + 1])}, along);
  }

  std::vector<Stretch> all;

 private:
  static const PointResult* state(const PointResult* row) {
    return row && is_state(*row) ? row : nullptr;
  }
  void add(const std::array<const PointResult*, 4>& rows, Along along) {
    const PointResult &first = *rows[1], &second = *rows[2];
    const PointKey &a = first.key, &b = second.key;
    if (is_state(first) && is_state(second)) {
      if (auto ms = changing(first.modes, second.modes); !ms.empty())
        all.push_back({a, b, along, std::move(ms)});
      if (auto ms = turning(rows, along); !ms.empty())
        all.push_back({a, b, along, std::move(ms), axisym::Search::turns});
    } else if (is_state(first) && second.fold_side == "at") {
      all.push_back({a, b, along, all_ms_});
    } else if (is_state(second) && first.fold_side == "at") {
      all.push_back({b, a, along, all_ms_});
    }
  }

  const ScanTable& table_;
  std::vector<int> all_ms_;
};

std::vector<Stretch> stretches_of(const ScanInput& input, const ScanTable& table) {
  Stretches stretches(table, input.modes);
  for (const Model model : input.models)
    for (const Branch branch : input.branches) {
      const auto line = [&](const std::vector<double>& values, Along along, double other) {
        std::vector<PointKey> keys;
        keys.reserve(values.size());
        for (const double x : values)
          keys.push_back(along == Along::L ? PointKey{other, x, model, branch}
                                           : PointKey{x, other, model, branch});
        stretches.add(keys, along);
      };
      const std::size_t rows = model == Model::SSH ? 1 : input.L.size();
      for (std::size_t j = 0; j < rows; ++j)
        line(input.reduced_volume, Along::reduced_volume, input.L[j]);
      if (model == Model::SSH) continue;
      for (const double v : input.reduced_volume) line(input.L, Along::L, v);
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
       axisym::thresholds_along(line, *start, stretch.ms, input.numerics, promised, stretch.search))
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
