#include "studies/stability/stability.h"

#include "studies/io/interrupt.h"
#include "studies/io/progress.h"
#include "studies/io/results_folder.h"
#include "studies/io/stopwatch.h"
#include "studies/stability/stability_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace sbeh::studies {

namespace fs = std::filesystem;

namespace {

// The folder of a study: what is there, and how a run is kept.
class StabilityFolder {
 public:
  StabilityFolder(const StabilityInput& input, const fs::path& path, std::string_view version)
      : folder_(path),
        table_(stability_table(prepare(input, version))),
        left_(missing(input)),
        progress_("runs", int(keys_of(input).size()), int(keys_of(input).size() - left_.size())) {}

  /// The runs that are not there yet, in the order in which they are made.
  const std::vector<StabilityKey>& left() const { return left_; }

  /// Keeps a run: its history first, so that a row means that it is whole.
  void keep(const StabilityOutcome& outcome) {
    if (!outcome.history.empty())
      write_file(history_path(outcome.result.key),
                 table_text(perturbed_columns(), outcome.history));
    table_.append(outcome.result);
    ++computed_;
    progress_.advance();
  }

  void write(std::string_view name, const std::string& text) const {
    write_file(folder_ / name, text);
  }
  StabilityTable& table() { return table_; }
  Progress& progress() { return progress_; }
  int computed() const { return computed_; }

 private:
  const OutputFolder& prepare(const StabilityInput& input, std::string_view version) {
    begin_or_continue(folder_, describe(input, version), "stability.csv", "results");
    make_folder(folder_ / "runs");
    return folder_;
  }
  // The shortest first: rates are nearly proportional to L. A row whose history has gone counts as not there.
  std::vector<StabilityKey> missing(const StabilityInput& input) const {
    std::vector<StabilityKey> keys = keys_of(input);
    std::erase_if(keys, [&](const StabilityKey& key) {
      const StabilityResult* row = table_.find(key);
      return row && (row->steps == 0 || fs::exists(history_path(key)));
    });
    std::stable_sort(keys.begin(), keys.end(),
                     [](const auto& a, const auto& b) { return a.L > b.L; });
    return keys;
  }
  fs::path history_path(const StabilityKey& key) const {
    return folder_ / ("runs/" + stem(key) + ".csv");
  }

  OutputFolder folder_;
  StabilityTable table_;
  std::vector<StabilityKey> left_;
  Progress progress_;
  int computed_ = 0;
};

std::string rate_text(const StabilityResult& row) {
  return row.growth ? fmt::format("{:+.4g} ± {:.1g}", row.growth->rate, row.growth->error) : "–";
}

}  // namespace

StabilitySummary run_stability(const StabilityInput& input, const fs::path& path,
                               std::string_view version) {
  const Stopwatch watch;
  StabilityFolder folder(input, path, version);
  // One after the other, each on all cores: MUMPS is not made for several threads of one process.
  for (const StabilityKey& key : folder.left()) {
    if (interrupt_signal()) break;
    if (const auto outcome = run_perturbed(input, key)) folder.keep(*outcome);
  }
  folder.progress().finish();
  folder.table().sort();

  StabilitySummary summary;
  for (const auto& [key, row] : folder.table().rows()) summary.rows.push_back(row);
  if (!interrupt_signal()) {
    summary.thresholds = find_thresholds(input, summary.rows);
    if (!interrupt_signal())
      folder.write("thresholds.csv", table_text(threshold_columns(), summary.thresholds));
  }
  summary.computed = folder.computed();
  summary.interrupted = interrupt_signal() != 0;
  summary.seconds = watch.seconds();
  return summary;
}

std::string table_of(const StabilitySummary& summary) {
  std::string text =
      fmt::format("{:<6}{:>6}{:>8}  {:<8}{:<5}{:<10}{:<10}{:<22}{}\n", "model", "V_r", "L",
                  "branch", "l m", "verdict", "goes to", "rate", "energy");
  for (const StabilityResult& row : summary.rows) {
    const StabilityKey& k = row.key;
    text += fmt::format("{:<6}{:>6}{:>8}  {:<8}{} {:<3}{:<10}{:<10}{:<22}{:.8g} → {:.8g}{}\n",
                        sbeh::name(k.model), k.reduced_volume, k.L, name(k.branch), k.l, k.m,
                        name(row.verdict), row.end_state.empty() ? "–" : row.end_state,
                        rate_text(row), row.energy_axisymmetric, row.energy_end,
                        row.end_state.empty() ? "; " + row.stop_reason : "");
  }
  for (const Threshold& t : summary.thresholds)
    text += fmt::format(
        "{} {}, L = {}, l = {}, m = {}: the rate is 0 at V_r = {:.4f} ± {:.1g}{}\n",
        sbeh::name(t.below.model), name(t.below.branch), t.below.L, t.below.l, t.below.m,
        t.reduced_volume, t.error,
        std::isnan(t.harmonics) ? "" : fmt::format("; spherical harmonics: {:.4f}", t.harmonics));
  return text;
}

}  // namespace sbeh::studies
