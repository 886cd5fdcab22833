#include "studies/stability/stability_thresholds.h"

#include "studies/io/interrupt.h"
#include "studies/stability/classical_saddle.h"
#include "studies/witnesses/state.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <tuple>

namespace sbeh::studies {

namespace {

constexpr double bisection_width = 1e-4;

auto line_of(const StabilityKey& key) {
  return std::tie(key.model, key.L, key.branch, key.l, key.m);
}

// Between two volumes of which the directions differ; the change of m alone is not told apart.
double by_harmonics(const StabilityInput& input, const StabilityKey& key, double low, double high) {
  const auto count = [&](double v) {
    axisym::StationaryCase there = case_of(input, key, key.branch);
    there.reduced_volume = v;
    return classical_saddle(there);
  };
  const auto at_low = count(low), at_high = count(high);
  if (!at_low || !at_high || at_low->negative_directions == at_high->negative_directions)
    return not_known;
  while (high - low > bisection_width) {
    const double middle = (low + high) / 2;
    const auto there = count(middle);
    if (!there || interrupt_signal() != 0) return not_known;
    (there->negative_directions == at_low->negative_directions ? low : high) = middle;
  }
  return (low + high) / 2;
}

}  // namespace

std::vector<Threshold> find_thresholds(const StabilityInput& input,
                                       const std::vector<StabilityResult>& rows) {
  std::vector<const StabilityResult*> sorted;
  for (const StabilityResult& row : rows)
    if (row.growth) sorted.push_back(&row);
  std::stable_sort(sorted.begin(), sorted.end(),
                   [](const auto* a, const auto* b) { return line_of(a->key) < line_of(b->key); });
  std::vector<Threshold> thresholds;
  for (std::size_t i = 1; i < sorted.size(); ++i) {
    const StabilityResult &a = *sorted[i - 1], &b = *sorted[i];
    const double rise = b.growth->rate - a.growth->rate;
    if (line_of(a.key) != line_of(b.key) || a.growth->rate * b.growth->rate > 0 || rise == 0)
      continue;
    const double low = a.key.reduced_volume, high = b.key.reduced_volume;
    const double share = -a.growth->rate / rise, scale = (high - low) / std::abs(rise);
    Threshold threshold;
    threshold.below = a.key;
    threshold.upper_volume = high;
    threshold.reduced_volume = low + share * (high - low);
    threshold.error = scale * std::hypot((1 - share) * a.growth->error, share * b.growth->error);
    threshold.harmonics = by_harmonics(input, a.key, low, high);
    thresholds.push_back(threshold);
  }
  return thresholds;
}

const Columns<Threshold>& threshold_columns() {
  using Row = Threshold;
  using Key = StabilityKey;
  using model::Model;
  static const Columns<Row> columns{
      column<Row>("model", inside(&Row::below, &Key::model)),
      column<Row>("L", inside(&Row::below, &Key::L)),
      column<Row>("branch", inside(&Row::below, &Key::branch)),
      column<Row>("l", inside(&Row::below, &Key::l)),
      column<Row>("m", inside(&Row::below, &Key::m)),
      column("reduced_volume", &Row::reduced_volume),
      column("error", &Row::error, "{:.2g}"),
      column<Row>("below", inside(&Row::below, &Key::reduced_volume)),
      column("above", &Row::upper_volume),
      known_column("harmonics", &Row::harmonics, "{:.5f}"),
  };
  return columns;
}

}  // namespace sbeh::studies
