#include "studies/rest_states/states.h"

#include "studies/io/growing_table.h"
#include "studies/io/interrupt.h"
#include "studies/io/progress.h"
#include "studies/io/stopwatch.h"
#include "studies/rest_states/coarser_triangles.h"
#include "studies/rest_states/pass_crossing.h"
#include "studies/rest_states/rest_branch.h"
#include "studies/rest_states/rest_search.h"
#include "studies/rest_states/rest_state.h"

#include <fmt/format.h>

#include <cmath>

namespace sbeh::studies {

namespace {

void compute_places(const StatesInput& input, const OutputFolder& folder, RestTable& table,
                    StatesSummary& summary) {
  const std::vector<StatePlace> places = places_of(input);
  Progress progress("states", int(places.size()), int(table.rows().size()));
  for (const StatePlace& place : places) {
    if (interrupt_signal()) break;
    if (table.find(place.number)) continue;
    const RestRow row = rest_row(input, place, folder.path());
    if (interrupt_signal()) break;  // what it is made of may be cut short
    table.append(row);
    ++summary.computed;
    progress.advance();
  }
  progress.finish();
}

// Rows in the order in which they are found. Those that are there are gone through again, but not measured.
class RowsInOrder {
 public:
  RowsInOrder(const StatesInput& input, const OutputFolder& folder, RestTable& table,
              StatesSummary& summary)
      : input_(input), folder_(folder), table_(table), summary_(summary) {}

  int next() const { return number_; }

  std::string take(const FoundState& found) {
    const StatesInput here = input_on_way(input_, found.point.mu);
    const axisym::PlanePoint at = places_of(here).front().at;
    const double value = input_.follow ? value_on_way(input_, found.point.mu) : 0;
    if (input_.follow)
      line_.show(fmt::format("path {}: state {}, {} = {:.6g}", found.path, number_,
                             input_.follow->parameter, value));
    const model::Material material = here.material.with_L1(at.L);
    // Also of states that are there: an interruption changes nothing of what comes after it.
    const RestStart& coarser = coarser_.at(found.mesh, found.point, material, input_.model);
    const int number = number_++;
    if (const RestRow* there = table_.find(number)) return doubt(*there);
    RestRow row = row_at(here, {number, at});
    row.followed = value;
    row.path = found.path;
    row.point = found.kind;
    if (found.from > 0) row.from = found.from;
    const auto system = found.system ? found.system
                                     : std::make_shared<surface3d::NewtonSystem>(
                                         *found.mesh, material, input_.model);
    system->set_material(material);
    if (system->linearise(found.point, found.point.normals, {{}, found.point.phase})) {
      const SeenState seen{*system, found.mesh, found.point, found.point.normals, at};
      measure(here, seen, folder_.path(), row);
      if (!interrupt_signal()) row.energy_error = energy_error(here, row, coarser, true);
      if (std::isnan(row.energy_error)) row.energy_error = energy_error_on_path(here, row, seen);
    } else {
      row.stop_reason = "the matrix is singular";
    }
    if (interrupt_signal()) return "interrupted";
    table_.append(row);
    ++summary_.computed;
    return doubt(row);
  }

 private:
  static std::string doubt(const RestRow& row) {
    return row.status == PointStatus::unresolved ? row.stop_reason : "";
  }

  const StatesInput& input_;
  const OutputFolder& folder_;
  RestTable& table_;
  StatesSummary& summary_;
  CoarserTriangles coarser_;
  ProgressLine line_;
  int number_ = 1;
};

// What is found from the state of one place: its branch, or others.
void compute_from_one(const StatesInput& input, const OutputFolder& folder, RestTable& table,
                      StatesSummary& summary) {
  const StatePlace place = places_of(input).front();
  const RestState first = rest_state_from(input, place.at, rest_start(input, place.at));
  std::string failure = first.failure;
  if (failure.empty()) {
    RowsInOrder rows(input, folder, table, summary);
    const std::function number = [&] { return rows.next(); };
    const TakeState take = [&](const FoundState& found) { return rows.take(found); };
    if (input.search)
      search_states(input, first, number, take);
    else
      failure = follow_branches(input, first.mesh, first.state, number, take);
  }
  if (failure.empty() || interrupt_signal() || table.find(place.number)) return;
  RestRow row = row_at(input, place);
  row.stop_reason = failure;
  table.append(row);
  ++summary.computed;
}

}  // namespace

StatesSummary run_states(const StatesInput& input, const std::filesystem::path& path,
                         std::string_view version) {
  const Stopwatch watch;
  const OutputFolder folder(path);
  begin_or_continue(folder, describe(input, version), "states.csv", "states");
  const Columns<RestRow> columns = rest_columns(input);
  RestTable table(folder / "states.csv", columns, "states", "that state computed again");
  StatesSummary summary;
  if (!passes_begun(folder)) {
    if (input.follow || input.search)
      compute_from_one(input, folder, table, summary);
    else
      compute_places(input, folder, table, summary);
  }
  if (input.passes && !interrupt_signal()) {
    const auto there = int(table.rows().size());
    summary.passes = cross_passes(input, folder, table);
    summary.computed += int(table.rows().size()) - there;
  }
  for (const auto& [number, row] : table.rows()) summary.rows.push_back(row);
  summary.interrupted = interrupt_signal() != 0;
  summary.seconds = watch.seconds();
  return summary;
}

}  // namespace sbeh::studies
