// The numbers of a folder of results that matter most.
#include "studies/compare/compare.h"
#include "studies/diagram/diagram_table.h"
#include "studies/io/toml_reader.h"
#include "studies/modes/modes.h"
#include "studies/report/report.h"
#include "studies/rest_states/rest_row.h"
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

// The rows of a table if they are few: of some reduced volumes alone they would mislead. None where there is no table.
template <class Row>
std::vector<Row> few_rows(const Columns<Row>& columns, const fs::path& file) {
  constexpr std::size_t most = 12;
  std::vector<Row> rows = fs::exists(file) ? read_rows(columns, file) : std::vector<Row>{};
  return rows.size() <= most ? rows : std::vector<Row>{};
}

// The words in a column, in the order of their first row.
template <class Row, class Word>
std::string words_of(const std::vector<Row>& rows, Word word) {
  std::vector<std::string> words;
  for (const Row& row : rows)
    if (const std::string one = word(row); std::ranges::find(words, one) == words.end())
      words.push_back(one);
  return fmt::format("{}", fmt::join(words, ", "));
}

struct Range {
  double low = not_known, high = not_known;
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

Fact word(const std::string& what, const std::string& text) { return {what, html::escaped(text)}; }

std::string text_of(double value) { return html::value(fmt::format("{}", value)); }

using ShownUnits = std::optional<ResultUnits>;

double factor(const ShownUnits& units, const Dimension& dimension, std::optional<double> L = {}) {
  return units ? units->scales(L).factor(dimension) : 1;
}
std::string unit_after(const ShownUnits& units, const Dimension& dimension) {
  return units ? fmt::format(" {}", html::escaped(units->unit(dimension))) : "";
}
Fact number(const ShownUnits& units, const std::string& what, double value,
            const Dimension& dimension) {
  return {what, text_of(factor(units, dimension) * value) + unit_after(units, dimension)};
}
Fact with_unit(const ShownUnits& units, Fact fact, const Dimension& dimension) {
  fact.value += unit_after(units, dimension);
  return fact;
}
Fact number(const std::string& what, double value) { return {what, text_of(value)}; }

Fact rounded(const std::string& what, double value) {
  return word(what, fmt::format("{:.6g}", value));
}

template <class Row, class Number>
Fact range(const std::string& what, const std::vector<Row>& rows, Number number) {
  const auto [low, high] = range_of(rows, number);
  return low == high ? rounded(what, low) : word(what, fmt::format("{:.6g} … {:.6g}", low, high));
}

template <class Row, class Is>
Fact count(const std::string& what, const std::vector<Row>& rows, Is is) {
  return word(what, std::to_string(std::ranges::count_if(rows, is)));
}

// Of rows of scans and studies of stability.
std::string model_of(const auto& row) { return sbeh::name(row.key.model); }
std::string branch_of(const auto& row) { return sbeh::name(row.key.branch); }
std::vector<Fact> facts_of_grid(const auto& rows) {
  return {range("reduced volume", rows, [](const auto& row) { return row.key.reduced_volume; }),
          range("elastic constant L", rows, [](const auto& row) { return row.key.L; })};
}

// Of the state that a row has: at a fold, that of the fold's L.
double L_of_state(const PointResult& row) {
  return row.fold_side == "at" ? row.fold_L.value_or(row.key.L) : row.key.L;
}

Fact fact_of(const FoldRow& fold) {
  if (is_along_volume(fold))
    return {fmt::format("fold of the {} at L = {:.6g}", name(fold.branch), fold.L),
            "V_r = " + text_of(fold.reduced_volume)};
  return {fmt::format("fold of the {} at V_r = {:.6g}", name(fold.branch), fold.reduced_volume),
          "L = " + text_of(fold.L) + (fold.kind ? fmt::format(" ({})", name(*fold.kind)) : "")};
}

KeyNumbers of_scan(const fs::path& folder, const ShownUnits& units) {
  using Row = PointResult;
  const auto points = rows_of(scan_columns(), folder / "scan.csv");
  const auto measured = [](auto member) {
    return [=](const Row& row) {
      return row.diagnostics ? std::invoke(member, *row.diagnostics) : not_known;
    };
  };
  std::vector<Fact> facts = facts_of_grid(points);
  facts.push_back(word("branches", words_of(points, branch_of<Row>)));
  for (const PointStatus status : values_of(PointStatus{}))
    facts.push_back(count(fmt::format("points {}", name(status)), points,
                          [&](const Row& row) { return row.status == status; }));
  const auto energy = [&](const Row& row) {
    return row.diagnostics
             ? factor(units, dimension::energy, L_of_state(row)) * row.diagnostics->energy.total()
             : not_known;
  };
  facts.push_back(with_unit(units, range("energy", points, energy), dimension::energy));
  facts.push_back(
      rounded("smallest order", range_of(points, measured(&axisym::Diagnostics::order_min)).low));
  facts.push_back(
      with_unit(units,
                rounded("largest |H|",
                        factor(units, dimension::curvature)
                            * range_of(points, measured(&axisym::Diagnostics::H_abs_max)).high),
                dimension::curvature));
  for (const FoldRow& fold : few_rows(fold_columns(), folder / "folds.csv"))
    facts.push_back(fact_of(fold));
  return {fmt::format("Stationary shapes: {} over {} points", words_of(points, model_of<Row>),
                      points.size()),
          facts};
}

// What the resolved input says of the evolution's model; empty where it cannot be read.
std::string model_of_evolution(const fs::path& folder) {
  try {
    return TomlFile::parse(folder / "run.toml").text("model", "");
  } catch (const InputError&) {
    return "";
  }
}

KeyNumbers of_evolution(const fs::path& folder, ResultsKind kind, const ShownUnits& units) {
  const auto series = rows_of(series_columns(), folder / "series.csv");
  const SeriesRow& last = series.back();
  const model::FlowRecord& end = last.record;
  const std::string model = model_of_evolution(folder);
  const auto of_energy = [&](const char* what, double value) {
    return number(units, what, value, dimension::energy);
  };
  const Range area = range_of(series, &SeriesRow::area),
              volume = range_of(series, &SeriesRow::volume),
              quality = range_of(series, &SeriesRow::mesh_quality);
  return {
      fmt::format("{} evolution{} to t = {:.6g}{}",
                  kind == ResultsKind::run ? "3D" : "Axisymmetric",
                  model.empty() ? "" : " of " + model, factor(units, dimension::time) * end.time,
                  unit_after(units, dimension::time)),
      {of_energy("energy at the start", series.front().record.energy.total()),
       of_energy("energy at the end", end.energy.total()),
       of_energy("… distortion", end.energy.distortion),
       of_energy("… bending", end.energy.bending),
       of_energy("… thermotropic", end.energy.thermotropic),
       number("reduced volume", last.reduced_volume),
       {"order at the end: least, mean, largest",
        text_of(last.order_min) + ", " + text_of(last.order_mean) + ", " + text_of(last.order_max)},
       number(units, "largest |H| at the end", last.H_abs_max, dimension::curvature),
       number(units, "pressure multiplier λ at the end", end.lambda, dimension::pressure),
       number(units, "largest speed at the end", end.speed_max, dimension::speed),
       word("area and volume vary by",
            fmt::format("{:.1e}{}, {:.1e}{}",
                        factor(units, dimension::area) * (area.high - area.low),
                        unit_after(units, dimension::area),
                        factor(units, dimension::volume) * (volume.high - volume.low),
                        unit_after(units, dimension::volume))),
       word("worst mesh quality", fmt::format("{:.4g}", quality.low)),
       number("steps rejected", end.rejected)}};
}

KeyNumbers of_seifert(const fs::path& folder) {
  std::vector<Fact> facts;
  for (PointRow& row : rows_of(point_columns(), folder / "points.csv")) {
    std::ranges::replace(row.name, '_', ' ');
    facts.push_back(
        {row.name + ": V_r", text_of(row.point.reduced_volume) + " ± " + text_of(row.point.error)});
    facts.push_back(number(row.name + ": F/(8πκ)", row.point.energy));
  }
  return {"The classical shapes by three witnesses", facts};
}

KeyNumbers of_diagram(const fs::path& folder) {
  const DiagramInput input = read_diagram(folder / "run.toml");
  const auto rows = rows_of(bifurcation_columns(), folder / "bifurcations.csv");
  const auto of_kind = [&](std::string_view kind) {
    return std::to_string(std::ranges::count(rows, kind, &Bifurcation::kind));
  };
  double error = 0;
  for (const Bifurcation& row : rows)
    if (!std::isnan(row.error)) error = std::max(error, row.error);
  return {fmt::format("The {} diagram", name(input.kind)),
          {{"values", std::to_string(input.values.size())},
           {"losses of symmetry", of_kind("symmetry_loss")},
           {"folds", of_kind("fold")},
           {"closing necks", of_kind("limit")},
           {"equal energies", of_kind("equal_energy")},
           number("largest error of V_r", error)}};
}

KeyNumbers of_compare(const fs::path& folder, const ShownUnits& units) {
  const auto comparisons = read_rows(comparison_columns(), folder / "compare.csv");
  const auto methods = rows_of(method_columns(), folder / "methods.csv");
  const auto method = [](const WitnessState& state) { return name(state.witness); };
  const auto known = [&](double value, const Dimension& dimension) {
    return std::isnan(value) ? "" : number(units, "", value, dimension).value;
  };
  std::vector<Fact> facts{
      count("methods without a state", methods,
            [](const WitnessState& state) { return !state.failure.empty(); }),
      count("tolerances kept", comparisons,
            [](const Comparison& one) { return one.tolerance && !one.misses(); }),
      count("tolerances missed", comparisons, [](const Comparison& one) { return one.misses(); })};
  for (const WitnessState& state : methods)
    facts.push_back({fmt::format("energy by {}", name(state.witness)),
                     known(state.measures.energy, dimension::energy)});
  for (const Comparison& one : comparisons)
    if (one.quantity == "distance")
      facts.push_back({fmt::format("distance of {} and {}", name(one.first), name(one.second)),
                       known(one.difference, dimension::length)});
  return {fmt::format("One case by {}", words_of(methods, method)), facts};
}

KeyNumbers of_stability(const fs::path& folder, const ShownUnits& units) {
  using Row = StabilityResult;
  const auto runs = rows_of(stability_columns(), folder / "stability.csv");
  std::vector<Fact> facts = facts_of_grid(runs);
  for (const Verdict verdict : values_of(Verdict{}))
    facts.push_back(count(fmt::format("runs: {}", name(verdict)), runs,
                          [&](const Row& row) { return row.verdict == verdict; }));
  const auto rate = [&](const Row& row) {
    return row.growth ? factor(units, dimension::rate, row.key.L) * row.growth->rate : not_known;
  };
  facts.push_back(units ? with_unit(units, range("rates", runs, rate), dimension::rate)
                        : range("rates over κ(2/3)", runs, &Row::reduced_rate));
  for (const Threshold& t : few_rows(threshold_columns(), folder / "thresholds.csv"))
    facts.push_back({fmt::format("eigenvalue 0 of {} {}, L = {}, m = {}", sbeh::name(t.below.model),
                                 name(t.below.branch), t.below.L, t.below.m),
                     "V_r = " + text_of(t.reduced_volume)});
  return {fmt::format("Stability in 3D: {} {}", words_of(runs, model_of<Row>),
                      words_of(runs, branch_of<Row>)),
          facts};
}

KeyNumbers of_modes(const fs::path& folder, const ShownUnits& units) {
  const auto modes = rows_of(mode_columns(), folder / "modes.csv");
  const ModesInput input = read_modes(folder / "run.toml");
  const auto& state = input.state;
  std::vector<Fact> facts{
      number("reduced volume", state.reduced_volume), number("elastic constant L", state.L()),
      count("negative eigenvalues", modes, [](const ModeRow& row) { return row.eigenvalue < 0; })};
  for (const ModeRow& row : modes)
    if (row.key.number == 1)
      facts.push_back(number(units, fmt::format("λ of m = {}, {}", row.key.m, name(row.key.parity)),
                             row.eigenvalue, dimension::energy));
  return {fmt::format("Modes of the {} {}", sbeh::name(state.model), name(state.branch)), facts};
}

KeyNumbers of_states(const fs::path& folder, const ShownUnits& units) {
  const StatesInput input = read_states(folder / "run.toml");
  const auto rows = rows_of(rest_columns(input), folder / "states.csv");
  const auto found = [](const RestRow& row) { return row.status == PointStatus::stationary; };
  std::vector<Fact> facts{count("states", rows, found),
                          count("without a state, or not resolved", rows, std::not_fn(found)),
                          count("minima", rows, [&](const RestRow& row) {
                            return found(row) && row.measures->negative_directions == 0;
                          })};
  const RestRow* lowest = nullptr;
  for (const RestRow& row : rows)
    if (found(row) && (!lowest || energy_of(row) < energy_of(*lowest))) lowest = &row;
  if (lowest) {
    facts.push_back(
        word("lowest", fmt::format("number {}, {}", lowest->key, lowest->measures->symmetry)));
    facts.push_back(
        {"its energy", text_of(factor(units, dimension::energy, lowest->L) * energy_of(*lowest))
                           + unit_after(units, dimension::energy)});
  }
  return {fmt::format("Rest states in 3D: {}", sbeh::name(input.model)), facts};
}

}  // namespace

KeyNumbers key_numbers(const fs::path& folder, ResultsKind kind, const ShownUnits& units) {
  switch (kind) {
    case ResultsKind::scan:
      return of_scan(folder, units);
    case ResultsKind::run:
    case ResultsKind::relax:
      return of_evolution(folder, kind, units);
    case ResultsKind::seifert:
      return of_seifert(folder);
    case ResultsKind::diagram:
      return of_diagram(folder);
    case ResultsKind::compare:
      return of_compare(folder, units);
    case ResultsKind::stability:
      return of_stability(folder, units);
    case ResultsKind::modes:
      return of_modes(folder, units);
    case ResultsKind::states:
      return of_states(folder, units);
  }
  return {};
}

}  // namespace sbeh::studies
