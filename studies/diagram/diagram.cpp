#include "studies/diagram/diagram.h"

#include "studies/io/interrupt.h"
#include "studies/io/output.h"
#include "studies/io/progress.h"
#include "studies/io/stopwatch.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <map>
#include <mutex>
#include <string>
#include <type_traits>
#include <utility>

namespace sbeh::studies {

namespace {

struct OneValue {
  std::vector<DiagramRow> rows;
  std::vector<Bifurcation> bifurcations;
  std::vector<DiagramShapeRow> shapes;
  bool is_done = false;
};

// Shapes are drawn at some eight of the values.
bool has_shapes(std::size_t k, std::size_t count) {
  constexpr std::size_t lines_of_shapes = 8;
  const std::size_t stride = std::max<std::size_t>(1, count / lines_of_shapes);
  return k % stride == stride / 2;
}

OneValue at_value(const DiagramInput& input, std::size_t k,
                  const std::vector<DiagramBranch>& classical) {
  constexpr int numbers = 100;  // of shapes at one value, at the most
  const double value = input.values[k];
  OneValue one;
  const auto branches = branches_at(input, value, classical);
  for (const DiagramBranch& branch : branches) {
    const auto rows = rows_of(value, branch);
    one.rows.insert(one.rows.end(), rows.begin(), rows.end());
  }
  one.bifurcations = bifurcations_of(input, value, branches);
  if (has_shapes(k, input.values.size())) one.shapes = lowest_shapes(input, value, branches);
  for (DiagramShapeRow& row : one.shapes) row.number += numbers * int(k);
  one.is_done = true;
  return one;
}

// The three tables: `visit` takes the name of each, its columns and where a value has its rows.
template <class Visit>
void for_each_table(Visit&& visit) {
  visit("branches.csv", diagram_columns(), &OneValue::rows);
  visit("bifurcations.csv", bifurcation_columns(), &OneValue::bifurcations);
  visit("shapes.csv", diagram_shape_columns(), &OneValue::shapes);
}

double value_of(const DiagramRow& row) { return row.at.value; }
double value_of(const Bifurcation& row) { return row.at.value; }
double value_of(const DiagramShapeRow& row) { return row.value; }

// What an earlier run has left, value by value.
void read_tables(const OutputFolder& folder, const DiagramInput& input,
                 std::vector<OneValue>& all) {
  for_each_table([&](const char* name, const auto& columns, const auto member) {
    if (!std::filesystem::exists(folder / name)) return;
    for (const auto& row : read_rows(columns, folder / name)) {
      const auto at = std::ranges::find(input.values, value_of(row));
      if (at != input.values.end())
        (all[std::size_t(at - input.values.begin())].*member).push_back(row);
    }
  });
  for (OneValue& one : all) one.is_done = !one.rows.empty();
}

// branches.csv, by which a value counts as done, comes last.
void write_tables(const OutputFolder& folder, const std::vector<OneValue>& all) {
  std::map<std::string, std::string> texts;
  for_each_table([&](const char* name, const auto& columns, const auto member) {
    std::remove_cvref_t<decltype(all.front().*member)> rows;
    for (const OneValue& one : all)
      if (one.is_done) rows.insert(rows.end(), (one.*member).begin(), (one.*member).end());
    texts[name] = table_text(columns, rows);
  });
  for (const char* name : {"shapes.csv", "bifurcations.csv", "branches.csv"})
    write_file(folder / name, texts[name]);
}

}  // namespace

DiagramSummary run_diagram(const DiagramInput& input, const std::filesystem::path& path,
                           std::string_view version) {
  const Stopwatch watch;
  const OutputFolder folder(path);
  begin_or_continue(folder, describe(input, version), "branches.csv", "a diagram");
  std::vector<OneValue> all(input.values.size());
  read_tables(folder, input, all);
  const auto there = int(std::ranges::count(all, true, &OneValue::is_done));
  std::vector<DiagramBranch> classical;
  if (input.kind == DiagramKind::bilayer_coupling && there < int(all.size()))
    classical = classical_diagram_branches(input);

  DiagramSummary summary;
  Progress progress("values", int(all.size()), there);
  std::mutex tables;
  tbb::parallel_for(
      std::size_t(0), all.size(),
      [&](std::size_t k) {
        if (all[k].is_done || interrupt_signal()) return;
        OneValue one = at_value(input, k, classical);
        if (interrupt_signal()) return;  // it may be cut short
        const std::lock_guard lock(tables);
        all[k] = std::move(one);
        write_tables(folder, all);
        ++summary.computed;
        progress.advance();
      },
      tbb::simple_partitioner());
  progress.finish();

  for (std::size_t k = 0; k < all.size(); ++k) {
    summary.states += all[k].rows.size();
    summary.bifurcations.insert(summary.bifurcations.end(), all[k].bifurcations.begin(),
                                all[k].bifurcations.end());
    if (all[k].is_done && all[k].rows.empty()) summary.missing.push_back(input.values[k]);
    summary.interrupted = summary.interrupted || !all[k].is_done;
  }
  summary.seconds = watch.seconds();
  return summary;
}

std::string table_of(const DiagramSummary& summary) {
  std::map<std::string, int> counts;
  for (const Bifurcation& b : summary.bifurcations) {
    const std::string name =
        b.kind == "symmetry_loss"  ? fmt::format("{} leaves {}", b.branch, b.from)
        : b.kind == "equal_energy" ? fmt::format("equal energy of {} and {}", b.branch, b.from)
                                   : fmt::format("{} of {}", b.kind, b.branch);
    ++counts[name];
  }
  std::string text;
  for (const auto& [name, count] : counts) text += fmt::format("  {:<44} {:>4}\n", name, count);
  return text;
}

}  // namespace sbeh::studies
