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
#include <utility>

namespace sbeh::studies {

namespace {

struct OneValue {
  std::vector<DiagramRow> rows;
  std::vector<Bifurcation> bifurcations;
  std::vector<DiagramShapeRow> shapes;
  bool is_done = false;
};

OneValue at_value(const DiagramInput& input, double value,
                  const std::vector<DiagramBranch>& classical) {
  OneValue one;
  const auto branches = branches_at(input, value, classical);
  for (const DiagramBranch& branch : branches) {
    const auto rows = rows_of(value, branch);
    one.rows.insert(one.rows.end(), rows.begin(), rows.end());
  }
  one.bifurcations = bifurcations_of(input, value, branches);
  one.shapes = lowest_shapes(input, value, branches);
  one.is_done = true;
  return one;
}

}  // namespace

DiagramSummary run_diagram(const DiagramInput& input, const std::filesystem::path& path,
                           std::string_view version) {
  const Stopwatch watch;
  const OutputFolder folder(path);
  refuse_results(folder, {"run.toml", "branches.csv", "bifurcations.csv"});
  std::vector<DiagramBranch> classical;
  if (input.kind == DiagramKind::bilayer_coupling) classical = classical_diagram_branches(input);

  std::vector<OneValue> all(input.values.size());
  Progress progress("values", int(all.size()), 0);
  std::mutex told;
  tbb::parallel_for(
      std::size_t(0), all.size(),
      [&](std::size_t k) {
        if (interrupt_signal()) return;
        all[k] = at_value(input, input.values[k], classical);
        const std::lock_guard lock(told);
        progress.advance();
      },
      tbb::simple_partitioner());
  progress.finish();

  DiagramSummary summary;
  std::vector<DiagramRow> rows;
  std::vector<DiagramShapeRow> shapes;
  constexpr std::size_t lines_of_shapes = 8;
  const std::size_t stride = std::max<std::size_t>(1, all.size() / lines_of_shapes);
  for (std::size_t k = 0; k < all.size(); ++k) {
    rows.insert(rows.end(), all[k].rows.begin(), all[k].rows.end());
    summary.bifurcations.insert(summary.bifurcations.end(), all[k].bifurcations.begin(),
                                all[k].bifurcations.end());
    if (k % stride == stride / 2)
      for (DiagramShapeRow& row : all[k].shapes) {
        row.number += 100 * int(k);
        shapes.push_back(std::move(row));
      }
    if (all[k].is_done && all[k].rows.empty()) summary.missing.push_back(input.values[k]);
    summary.interrupted = summary.interrupted || !all[k].is_done;
  }
  summary.states = rows.size();
  summary.seconds = watch.seconds();
  write_file(folder / "run.toml", describe(input, version));
  write_file(folder / "branches.csv", table_text(diagram_columns(), rows));
  write_file(folder / "bifurcations.csv", table_text(bifurcation_columns(), summary.bifurcations));
  write_file(folder / "shapes.csv", table_text(diagram_shape_columns(), shapes));
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
