// The numbers of a folder of results that matter most.
#include "studies/io/csv_table.h"
#include "studies/io/toml_reader.h"
#include "studies/report/report.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace sbeh::studies {

namespace fs = std::filesystem;
using html::Fact;

namespace {

CsvTable rows_of(const fs::path& file) {
  CsvTable table = read_csv(file);
  if (table.rows.empty())
    throw InputError(fmt::format("{}: has no rows yet: there is nothing to report", file.string()));
  return table;
}

// The words of a column, in the order of their first row.
std::vector<std::string> words_of(const CsvTable& table, const char* column) {
  std::vector<std::string> words;
  for (std::size_t row = 0; row < table.rows.size(); ++row) {
    const std::string word = table.text(row, column);
    if (std::find(words.begin(), words.end(), word) == words.end()) words.push_back(word);
  }
  return words;
}

struct Range {
  double low = std::nan(""), high = std::nan("");
  std::string text() const {
    return low == high ? fmt::format("{:.6g}", low) : fmt::format("{:.6g} … {:.6g}", low, high);
  }
};
Range range_of(const CsvTable& table, const char* column) {
  Range range;
  for (std::size_t row = 0; row < table.rows.size(); ++row) {
    const double value = table.number(row, column);
    if (!std::isfinite(value)) continue;
    range.low = std::isnan(range.low) ? value : std::min(range.low, value);
    range.high = std::isnan(range.high) ? value : std::max(range.high, value);
  }
  return range;
}

std::size_t rows_with(const CsvTable& table, const char* column, std::string_view word) {
  std::size_t count = 0;
  for (std::size_t row = 0; row < table.rows.size(); ++row)
    count += table.text(row, column) == word;
  return count;
}

Fact fact_of(const char* what, const CsvTable& table, std::size_t row, const char* column) {
  return {what, html::value(table.text(row, column))};
}

Fact word(const char* what, const std::string& text) { return {what, html::escaped(text)}; }

KeyNumbers of_scan(const fs::path& folder) {
  const CsvTable scan = rows_of(folder / "scan.csv");
  KeyNumbers numbers{
      .title = fmt::format("Stationary shapes: {} over {} points",
                           fmt::join(words_of(scan, "model"), ", "), scan.rows.size()),
      .facts = {}};
  std::vector<Fact>& facts = numbers.facts;
  facts.push_back(word("reduced volume", range_of(scan, "reduced_volume").text()));
  facts.push_back(word("elastic constant L", range_of(scan, "L").text()));
  facts.push_back(word("branches", fmt::format("{}", fmt::join(words_of(scan, "branch"), ", "))));
  for (const char* status : {"stationary", "unresolved", "failed"})
    facts.push_back(word(fmt::format("points {}", status).c_str(),
                         std::to_string(rows_with(scan, "status", status))));
  facts.push_back(word("energy", range_of(scan, "energy").text()));
  facts.push_back(word("smallest order", fmt::format("{:.6g}", range_of(scan, "order_min").low)));
  facts.push_back(word("largest |H|", fmt::format("{:.6g}", range_of(scan, "H_abs_max").high)));
  if (!fs::exists(folder / "folds.csv")) return numbers;
  const CsvTable folds = read_csv(folder / "folds.csv");
  for (std::size_t row = 0; row < std::min<std::size_t>(folds.rows.size(), 8); ++row)
    facts.push_back({fmt::format("fold of the {} at V_r = {:.6g}", folds.text(row, "branch"),
                                 folds.number(row, "reduced_volume")),
                     "L = " + html::value(folds.text(row, "L"))});
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
  const CsvTable series = rows_of(folder / "series.csv");
  const std::size_t last = series.rows.size() - 1;
  const std::string model = model_of_evolution(folder);
  KeyNumbers numbers{
      .title = fmt::format("{} evolution{} to t = {:.6g}",
                           kind == ResultsKind::run ? "3D" : "Axisymmetric",
                           model.empty() ? "" : " of " + model, series.number(last, "time")),
      .facts = {}};
  std::vector<Fact>& facts = numbers.facts;
  facts.push_back(fact_of("energy at the start", series, 0, "energy"));
  facts.push_back(fact_of("energy at the end", series, last, "energy"));
  facts.push_back(fact_of("… distortion", series, last, "energy_distortion"));
  facts.push_back(fact_of("… bending", series, last, "energy_bending"));
  facts.push_back(fact_of("… thermotropic", series, last, "energy_thermotropic"));
  facts.push_back(fact_of("reduced volume", series, last, "reduced_volume"));
  facts.push_back({"order at the end: least, mean, largest",
                   html::value(series.text(last, "order_min")) + ", "
                       + html::value(series.text(last, "order_mean")) + ", "
                       + html::value(series.text(last, "order_max"))});
  facts.push_back(fact_of("largest |H| at the end", series, last, "H_abs_max"));
  facts.push_back(fact_of("pressure multiplier λ at the end", series, last, "lambda"));
  facts.push_back(fact_of("largest speed at the end", series, last, "speed_max"));
  const Range area = range_of(series, "area"), volume = range_of(series, "volume");
  facts.push_back(
      word("area and volume vary by",
           fmt::format("{:.1e}, {:.1e}", area.high - area.low, volume.high - volume.low)));
  facts.push_back(
      word("worst mesh quality", fmt::format("{:.4g}", range_of(series, "mesh_quality").low)));
  facts.push_back(fact_of("steps rejected", series, last, "rejected_steps"));
  return numbers;
}

KeyNumbers of_seifert(const fs::path& folder) {
  const CsvTable points = rows_of(folder / "points.csv");
  KeyNumbers numbers{.title = "The classical shapes by three witnesses", .facts = {}};
  for (std::size_t row = 0; row < points.rows.size(); ++row) {
    std::string name = points.text(row, "name");
    std::replace(name.begin(), name.end(), '_', ' ');
    numbers.facts.push_back({name + ": V_r", html::value(points.text(row, "reduced_volume")) + " ± "
                                                 + html::value(points.text(row, "error"))});
    numbers.facts.push_back({name + ": F/(8πκ)", html::value(points.text(row, "energy_reduced"))});
  }
  return numbers;
}

KeyNumbers of_compare(const fs::path& folder) {
  const CsvTable compare = read_csv(folder / "compare.csv"),
                 methods = rows_of(folder / "methods.csv");
  KeyNumbers numbers{
      .title = fmt::format("One case by {}", fmt::join(words_of(methods, "method"), ", ")),
      .facts = {}};
  std::vector<Fact>& facts = numbers.facts;
  facts.push_back(
      word("methods without a state", std::to_string(rows_with(methods, "status", "failed"))));
  facts.push_back(word("tolerances kept", std::to_string(rows_with(compare, "agrees", "yes"))));
  facts.push_back(word("tolerances missed", std::to_string(rows_with(compare, "agrees", "no"))));
  for (std::size_t row = 0; row < methods.rows.size(); ++row)
    facts.push_back(
        {"energy by " + methods.text(row, "method"), html::value(methods.text(row, "energy"))});
  for (std::size_t row = 0; row < compare.rows.size(); ++row)
    if (compare.text(row, "quantity") == "distance")
      facts.push_back({fmt::format("distance of {} and {}", compare.text(row, "first"),
                                   compare.text(row, "second")),
                       html::value(compare.text(row, "difference"))});
  return numbers;
}

KeyNumbers of_stability(const fs::path& folder) {
  const CsvTable runs = rows_of(folder / "stability.csv");
  KeyNumbers numbers{
      .title = fmt::format("Stability in 3D: {} {}", fmt::join(words_of(runs, "model"), ", "),
                           fmt::join(words_of(runs, "branch"), ", ")),
      .facts = {}};
  std::vector<Fact>& facts = numbers.facts;
  facts.push_back(word("reduced volume", range_of(runs, "reduced_volume").text()));
  facts.push_back(word("elastic constant L", range_of(runs, "L").text()));
  for (const char* verdict : {"stays", "leaves", "undecided", "failed"})
    facts.push_back(word(fmt::format("runs: {}", verdict).c_str(),
                         std::to_string(rows_with(runs, "verdict", verdict))));
  facts.push_back(word("rates over κ(2/3)", range_of(runs, "reduced_rate").text()));
  if (!fs::exists(folder / "thresholds.csv")) return numbers;
  const CsvTable thresholds = read_csv(folder / "thresholds.csv");
  for (std::size_t row = 0; row < std::min<std::size_t>(thresholds.rows.size(), 8); ++row)
    facts.push_back({fmt::format("rate 0 of {} {}, L = {}, m = {}", thresholds.text(row, "model"),
                                 thresholds.text(row, "branch"), thresholds.text(row, "L"),
                                 thresholds.text(row, "m")),
                     "V_r = " + html::value(thresholds.text(row, "reduced_volume"))});
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
