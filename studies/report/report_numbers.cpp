// The numbers of a folder of results that matter most.
#include "studies/compare/compare.h"
#include "studies/io/toml_reader.h"
#include "studies/report/report.h"
#include "studies/scan/branch_lines.h"
#include "studies/seifert/seifert.h"
#include "studies/stability/stability.h"
#include "studies/states/series_file.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace sbeh::studies {

namespace fs = std::filesystem;
using html::Fact;

namespace {

template <class Row>
std::vector<Row> rows_of(const Columns<Row>& columns, const fs::path& file) {
  std::vector<Row> rows = read_rows(columns, file);
  if (rows.empty())
    throw InputError(fmt::format("{}: has no rows yet: there is nothing to report", file.string()));
  return rows;
}

// The words in a column, in the order of their first row.
template <class Row, class Word>
std::vector<std::string> words_of(const std::vector<Row>& rows, Word word) {
  std::vector<std::string> words;
  for (const Row& row : rows)
    if (const std::string one = std::invoke(word, row);
        std::find(words.begin(), words.end(), one) == words.end())
      words.push_back(one);
  return words;
}

struct Range {
  double low = not_known, high = not_known;
  std::string text() const {
    return low == high ? fmt::format("{:.6g}", low) : fmt::format("{:.6g} … {:.6g}", low, high);
  }
};
template <class Row, class Number>
Range range_of(const std::vector<Row>& rows, Number number) {
  Range range;
  for (const Row& row : rows) {
    const double value = std::invoke(number, row);
    if (!std::isfinite(value)) continue;
    range.low = std::fmin(range.low, value);
    range.high = std::fmax(range.high, value);
  }
  return range;
}

template <class Row, class Is>
std::string count(const std::vector<Row>& rows, Is is) {
  return std::to_string(std::count_if(rows.begin(), rows.end(), is));
}

Fact word(const std::string& what, const std::string& text) { return {what, html::escaped(text)}; }

std::string text_of(double value) { return html::value(fmt::format("{}", value)); }
Fact number(const std::string& what, double value) { return {what, text_of(value)}; }

// Of a scan's point: a number of its diagnostics.
template <class Member>
auto measured(Member member) {
  return [=](const PointResult& row) {
    return row.diagnostics ? std::invoke(member, *row.diagnostics) : not_known;
  };
}

KeyNumbers of_scan(const fs::path& folder) {
  const auto points = rows_of(scan_columns(), folder / "scan.csv");
  const auto key = [](auto member) { return inside(&PointResult::key, member); };
  const auto model = [](const PointResult& row) { return sbeh::name(row.key.model); };
  const auto branch = [](const PointResult& row) { return sbeh::name(row.key.branch); };
  KeyNumbers numbers{.title = fmt::format("Stationary shapes: {} over {} points",
                                          fmt::join(words_of(points, model), ", "), points.size()),
                     .facts = {}};
  std::vector<Fact>& facts = numbers.facts;
  facts.push_back(word("reduced volume", range_of(points, key(&PointKey::reduced_volume)).text()));
  facts.push_back(word("elastic constant L", range_of(points, key(&PointKey::L)).text()));
  facts.push_back(word("branches", fmt::format("{}", fmt::join(words_of(points, branch), ", "))));
  for (const PointStatus status : values_of(PointStatus{}))
    facts.push_back(word(fmt::format("points {}", name(status)),
                         count(points, [&](const auto& row) { return row.status == status; })));
  const auto energy = measured([](const axisym::Diagnostics& d) { return d.energy.total(); });
  const double least_order = range_of(points, measured(&axisym::Diagnostics::order_min)).low,
               largest_H = range_of(points, measured(&axisym::Diagnostics::H_abs_max)).high;
  facts.push_back(word("energy", range_of(points, energy).text()));
  facts.push_back(word("smallest order", fmt::format("{:.6g}", least_order)));
  facts.push_back(word("largest |H|", fmt::format("{:.6g}", largest_H)));
  if (!fs::exists(folder / "folds.csv")) return numbers;
  auto folds = read_rows(fold_columns(), folder / "folds.csv");
  folds.resize(std::min<std::size_t>(folds.size(), 8));
  for (const FoldRow& fold : folds)
    facts.push_back(
        {fmt::format("fold of the {} at V_r = {:.6g}", name(fold.branch), fold.reduced_volume),
         "L = " + text_of(fold.L)});
  return numbers;
}

// What the resolved input says of the evolution's model; empty where it cannot be read.
std::string model_of_evolution(const fs::path& folder) {
  try {
    const TomlTable file = TomlFile::parse(folder / "run.toml");
    return file.text("model", "");
  } catch (const InputError&) {
    return "";
  }
}

KeyNumbers of_evolution(const fs::path& folder, ResultsKind kind) {
  const auto series = rows_of(series_columns(), folder / "series.csv");
  const SeriesRow& last = series.back();
  const model::FlowRecord& end = last.record;
  const std::string model = model_of_evolution(folder);
  KeyNumbers numbers{.title = fmt::format("{} evolution{} to t = {:.6g}",
                                          kind == ResultsKind::run ? "3D" : "Axisymmetric",
                                          model.empty() ? "" : " of " + model, end.time),
                     .facts = {}};
  std::vector<Fact>& facts = numbers.facts;
  facts.push_back(number("energy at the start", series.front().record.energy.total()));
  facts.push_back(number("energy at the end", end.energy.total()));
  facts.push_back(number("… distortion", end.energy.distortion));
  facts.push_back(number("… bending", end.energy.bending));
  facts.push_back(number("… thermotropic", end.energy.thermotropic));
  facts.push_back(number("reduced volume", last.reduced_volume));
  facts.push_back(
      {"order at the end: least, mean, largest",
       text_of(last.order_min) + ", " + text_of(last.order_mean) + ", " + text_of(last.order_max)});
  facts.push_back(number("largest |H| at the end", last.H_abs_max));
  facts.push_back(number("pressure multiplier λ at the end", end.lambda));
  facts.push_back(number("largest speed at the end", end.speed_max));
  const Range area = range_of(series, &SeriesRow::area),
              volume = range_of(series, &SeriesRow::volume);
  facts.push_back(
      word("area and volume vary by",
           fmt::format("{:.1e}, {:.1e}", area.high - area.low, volume.high - volume.low)));
  facts.push_back(word("worst mesh quality",
                       fmt::format("{:.4g}", range_of(series, &SeriesRow::mesh_quality).low)));
  facts.push_back(number("steps rejected", end.rejected));
  return numbers;
}

KeyNumbers of_seifert(const fs::path& folder) {
  KeyNumbers numbers{.title = "The classical shapes by three witnesses", .facts = {}};
  for (PointRow& row : rows_of(point_columns(), folder / "points.csv")) {
    std::replace(row.name.begin(), row.name.end(), '_', ' ');
    numbers.facts.push_back(
        {row.name + ": V_r", text_of(row.point.reduced_volume) + " ± " + text_of(row.point.error)});
    numbers.facts.push_back(number(row.name + ": F/(8πκ)", row.point.energy));
  }
  return numbers;
}

KeyNumbers of_compare(const fs::path& folder) {
  const auto comparisons = read_rows(comparison_columns(), folder / "compare.csv");
  const auto methods = rows_of(method_columns(), folder / "methods.csv");
  const auto method = [](const WitnessState& state) { return name(state.witness); };
  KeyNumbers numbers{
      .title = fmt::format("One case by {}", fmt::join(words_of(methods, method), ", ")),
      .facts = {}};
  std::vector<Fact>& facts = numbers.facts;
  facts.push_back(word("methods without a state",
                       count(methods, [](const auto& state) { return !state.failure.empty(); })));
  facts.push_back(word("tolerances kept", count(comparisons, [](const Comparison& one) {
                         return one.tolerance && !one.misses();
                       })));
  facts.push_back(word("tolerances missed",
                       count(comparisons, [](const Comparison& one) { return one.misses(); })));
  for (const WitnessState& state : methods)
    facts.push_back({fmt::format("energy by {}", name(state.witness)),
                     std::isnan(state.measures.energy) ? "" : text_of(state.measures.energy)});
  for (const Comparison& one : comparisons)
    if (one.quantity == "distance")
      facts.push_back({fmt::format("distance of {} and {}", name(one.first), name(one.second)),
                       std::isnan(one.difference) ? "" : text_of(one.difference)});
  return numbers;
}

KeyNumbers of_stability(const fs::path& folder) {
  const auto runs = rows_of(stability_columns(), folder / "stability.csv");
  const auto key = [](auto member) { return inside(&StabilityResult::key, member); };
  const auto model = [](const StabilityResult& row) { return sbeh::name(row.key.model); };
  const auto branch = [](const StabilityResult& row) { return sbeh::name(row.key.branch); };
  KeyNumbers numbers{
      .title = fmt::format("Stability in 3D: {} {}", fmt::join(words_of(runs, model), ", "),
                           fmt::join(words_of(runs, branch), ", ")),
      .facts = {}};
  std::vector<Fact>& facts = numbers.facts;
  facts.push_back(
      word("reduced volume", range_of(runs, key(&StabilityKey::reduced_volume)).text()));
  facts.push_back(word("elastic constant L", range_of(runs, key(&StabilityKey::L)).text()));
  for (const Verdict verdict : values_of(Verdict{}))
    facts.push_back(word(fmt::format("runs: {}", name(verdict)),
                         count(runs, [&](const auto& row) { return row.verdict == verdict; })));
  facts.push_back(word("rates over κ(2/3)", range_of(runs, &StabilityResult::reduced_rate).text()));
  if (!fs::exists(folder / "thresholds.csv")) return numbers;
  auto thresholds = read_rows(threshold_columns(), folder / "thresholds.csv");
  thresholds.resize(std::min<std::size_t>(thresholds.size(), 8));
  for (const Threshold& t : thresholds)
    facts.push_back({fmt::format("rate 0 of {} {}, L = {}, m = {}", sbeh::name(t.below.model),
                                 name(t.below.branch), t.below.L, t.below.m),
                     "V_r = " + text_of(t.reduced_volume)});
  return numbers;
}

}  // namespace

KeyNumbers key_numbers(const fs::path& folder, ResultsKind kind) {
  switch (kind) {
    case ResultsKind::scan:
      return of_scan(folder);
    case ResultsKind::run:
    case ResultsKind::relax:
      return of_evolution(folder, kind);
    case ResultsKind::seifert:
      return of_seifert(folder);
    case ResultsKind::compare:
      return of_compare(folder);
    case ResultsKind::stability:
      return of_stability(folder);
  }
  return {};
}

}  // namespace sbeh::studies
