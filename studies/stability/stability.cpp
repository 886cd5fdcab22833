#include "studies/stability/stability.h"

#include "axisym/modes/threshold.h"
#include "axisym/stationary/symmetry.h"
#include "studies/io/interrupt.h"
#include "studies/io/output.h"
#include "studies/io/progress.h"
#include "studies/io/stopwatch.h"
#include "studies/scan/branch_points.h"
#include "studies/stability/linear_mode.h"
#include "studies/witnesses/state.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

namespace sbeh::studies {

namespace fs = std::filesystem;

namespace {

constexpr double bisection_width = 1e-4;

auto line_of(const StabilityKey& key) {
  return std::tie(key.model, key.L, key.branch, key.l, key.m);
}

// Between two volumes of which the directions differ; the change of m alone is not told apart.
double by_harmonics(const StabilityInput& input, const StabilityKey& key, double low, double high) {
  const auto count = [&](double v) {
    axisym::StationaryCase there = case_of(input, key);
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

// The zero of the mode's eigenvalue on the branch from a row to a higher reduced volume.
std::optional<axisym::Threshold> zero_between(const StabilityInput& input, const StabilityKey& from,
                                              double upper_volume) {
  const axisym::StationaryCase lower = case_of(input, from);
  const WitnessState state = newton_state(lower);
  const auto start = state.profile ? settled(lower, *state.profile) : std::nullopt;
  if (!start) return {};
  axisym::Line line{input.material, from.model, start->at, {upper_volume, from.L}};
  line.symmetric = axisym::is_symmetric(start->X);
  const std::array ms{from.m};
  for (auto& zero : axisym::thresholds_along(line, *start, ms, input.numerics))
    if (is_of_harmonic(from.l, from.m, zero.parity) && zero.is_located) return std::move(zero);
  return {};
}

std::string place_text(const Threshold& t) {
  return std::isnan(t.reduced_volume)
           ? fmt::format("between V_r = {} and {}", t.below.reduced_volume, t.upper_volume)
           : fmt::format("at V_r = {:.8f} ± {:.1g}", t.reduced_volume, t.error);
}
std::string mode_text(const StabilityResult& row) {
  return std::isnan(row.mode_rate) ? "–" : fmt::format("{:+.6g}", row.mode_rate);
}
std::string rate_text(const StabilityResult& row) {
  return row.growth ? fmt::format("{:+.4g} ± {:.1g}", row.growth->rate, row.growth->error) : "–";
}

}  // namespace

std::vector<Threshold> find_thresholds(const StabilityInput& input,
                                       const std::vector<StabilityResult>& rows) {
  std::vector<const StabilityResult*> sorted;
  for (const StabilityResult& row : rows)
    if (!std::isnan(row.eigenvalue)) sorted.push_back(&row);
  std::ranges::stable_sort(
      sorted, [](const auto* a, const auto* b) { return line_of(a->key) < line_of(b->key); });
  std::vector<Threshold> thresholds;
  for (std::size_t i = 1; i < sorted.size(); ++i) {
    const StabilityResult &a = *sorted[i - 1], &b = *sorted[i];
    if (line_of(a.key) != line_of(b.key) || (a.eigenvalue < 0) == (b.eigenvalue < 0)) continue;
    Threshold threshold{.below = a.key, .upper_volume = b.key.reduced_volume};
    if (const auto zero = zero_between(input, a.key, threshold.upper_volume)) {
      threshold.reduced_volume = zero->state.at.reduced_volume;
      threshold.error = zero->error;
    }
    threshold.harmonics = by_harmonics(input, a.key, a.key.reduced_volume, threshold.upper_volume);
    thresholds.push_back(threshold);
  }
  return thresholds;
}

const Columns<Threshold>& threshold_columns() {
  using Row = Threshold;
  using Key = StabilityKey;
  static const Columns<Row> columns{
      column<Row>("model", inside(&Row::below, &Key::model)),
      column<Row>("L", inside(&Row::below, &Key::L)),
      column<Row>("branch", inside(&Row::below, &Key::branch)),
      column<Row>("l", inside(&Row::below, &Key::l)),
      column<Row>("m", inside(&Row::below, &Key::m)),
      known_column("reduced_volume", &Row::reduced_volume),
      known_column("error", &Row::error, "{:.2g}"),
      column<Row>("below", inside(&Row::below, &Key::reduced_volume)),
      column("above", &Row::upper_volume),
      known_column("harmonics", &Row::harmonics, "{:.5f}"),
  };
  return columns;
}

StabilitySummary run_stability(const StabilityInput& input, const fs::path& path,
                               std::string_view version) {
  const Stopwatch watch;
  const OutputFolder folder(path);
  begin_or_continue(folder, describe(input, version), "stability.csv", "a study of stability");
  make_folder(folder / "runs");
  GrowingTable<StabilityResult> table(folder / "stability.csv", stability_columns(),
                                      "studies of stability", "its run made again");
  const auto history_path = [&](const StabilityKey& key) {
    return folder / ("runs/" + stem(key) + ".csv");
  };
  const auto is_there = [&](const StabilityKey& key) {  // with its history
    const StabilityResult* row = table.find(key);
    return row && (row->steps == 0 || fs::exists(history_path(key)));
  };
  std::vector<StabilityKey> left = keys_of(input);
  const auto all = int(left.size()), there = int(std::erase_if(left, is_there));
  // The shortest first: rates are nearly proportional to L.
  std::stable_sort(left.begin(), left.end(),
                   [](const auto& a, const auto& b) { return a.L > b.L; });
  Progress progress("runs", all, there);
  StabilitySummary summary;
  // One after the other, each on all cores: MUMPS is not made for several threads of one process.
  for (const StabilityKey& key : left) {
    if (interrupt_signal()) break;
    const auto outcome = run_perturbed(input, key);
    if (!outcome) continue;
    // The history first, so that a row means that it is whole.
    if (!outcome->history.empty())
      write_file(history_path(key), table_text(perturbed_columns(), outcome->history));
    table.append(outcome->result);
    ++summary.computed;
    progress.advance();
  }
  progress.finish();
  table.sort();

  for (const auto& [key, row] : table.rows()) summary.rows.push_back(row);
  if (!interrupt_signal()) summary.thresholds = find_thresholds(input, summary.rows);
  if (!interrupt_signal())
    write_file(folder / "thresholds.csv", table_text(threshold_columns(), summary.thresholds));
  summary.interrupted = interrupt_signal() != 0;
  summary.seconds = watch.seconds();
  return summary;
}

std::string table_of(const StabilitySummary& summary) {
  std::string text =
      fmt::format("{:<6}{:>6}{:>8}  {:<8}{:<5}{:<10}{:<10}{:<14}{:<22}{}\n", "model", "V_r", "L",
                  "branch", "l m", "verdict", "goes to", "rate by modes", "in 3D", "energy");
  for (const StabilityResult& row : summary.rows) {
    const StabilityKey& k = row.key;
    text += fmt::format("{:<6}{:>6}{:>8}  {:<8}{} {:<3}{:<10}{:<10}{:<14}{:<22}{:.8g} → {:.8g}{}\n",
                        sbeh::name(k.model), k.reduced_volume, k.L, name(k.branch), k.l, k.m,
                        name(row.verdict), row.end_state.empty() ? "–" : row.end_state,
                        mode_text(row), rate_text(row), row.energy_axisymmetric, row.energy_end,
                        row.end_state.empty() ? "; " + row.stop_reason : "");
  }
  for (const Threshold& t : summary.thresholds)
    text += fmt::format(
        "{} {}, L = {}, l = {}, m = {}: the eigenvalue is 0 {}{}\n", sbeh::name(t.below.model),
        name(t.below.branch), t.below.L, t.below.l, t.below.m, place_text(t),
        std::isnan(t.harmonics) ? "" : fmt::format("; spherical harmonics: {:.4f}", t.harmonics));
  return text;
}

}  // namespace sbeh::studies
