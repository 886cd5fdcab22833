// sweep.csv: inputs and results of all cases.
#include "axisym/shape_class.h"
#include "studies/evolution/evolution_files.h"
#include "studies/evolution/frame_file.h"
#include "studies/io/csv.h"
#include "studies/io/file_lock.h"
#include "studies/io/output.h"
#include "studies/io/toml_reader.h"
#include "studies/scan/scan_table.h"
#include "studies/states/profile_file.h"
#include "studies/sweep/sweep_status.h"
#include "surface3d/stationary/symmetry_class.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace sbeh::studies {

namespace fs = std::filesystem;

namespace {

using Fields = std::vector<std::string>;

bool is_evolution(InputKind kind) { return kind == InputKind::run || kind == InputKind::relax; }

// As they stand in the table, bit for bit.
Fields fields_of(const CsvTable& table, std::size_t row, const Fields& columns) {
  Fields fields;
  for (const std::string& column : columns) fields.push_back(table.text(row, column));
  return fields;
}

// ---- evolutions ---------------------------------------------------------------------------------

// Of the last row of a history: columns of series.csv.
const Fields& evolution_columns() {
  static const Fields columns{
      "time",           "energy",   "energy_distortion", "energy_bending", "energy_thermotropic",
      "reduced_volume", "W2",       "order_min",         "order_mean",     "order_max",
      "H_abs_max",      "speed_max"};
  return columns;
}

// The file of its last state; empty where that is not there, or not any more.
fs::path last_state_of(const fs::path& folder, const char* index) {
  if (!fs::exists(folder / index)) return {};
  const auto states = read_rows(frame_columns(), folder / index);
  const fs::path last = states.empty() ? fs::path() : folder / states.back().file;
  return fs::exists(last) ? last : fs::path();
}

// What its last state is, and why it is the last: columns class and stop_reason.
Fields end_of_run(const fs::path& folder) {
  const fs::path file = last_state_of(folder, "frames.csv");
  if (file.empty()) return {"", ""};
  const FlowMoment last = read_frame(file);
  const auto& ends = last.record.ends;
  return {surface3d::symmetry_class(*last.mesh, last.state), ends ? describe(*ends) : ""};
}

// An axisymmetric one that has ended well is at its end or at rest.
Fields end_of_relaxation(const fs::path& folder, bool well, double time) {
  using model::FlowStop;
  const fs::path file = last_state_of(folder, "profiles.csv");
  const double end = TomlFile::parse(folder / "run.toml").table("time").number("end");
  const bool at_end = time >= end * (1 - model::same_time);
  return {file.empty() ? "" : name(axisym::classify(read_profile(file).X)),
          well ? model::describe(at_end ? FlowStop::end_time : FlowStop::at_rest) : ""};
}

Fields results_of_evolution(const fs::path& file, InputKind kind, bool well) {
  const CsvTable series = read_csv(file);
  if (series.rows.empty()) return Fields(evolution_columns().size() + 2);
  const std::size_t last = series.rows.size() - 1;
  Fields fields = fields_of(series, last, evolution_columns());
  const Fields end = kind == InputKind::run
                       ? end_of_run(file.parent_path())
                       : end_of_relaxation(file.parent_path(), well, series.number(last, "time"));
  fields.insert(fields.end(), end.begin(), end.end());
  return fields;
}

// ---- states -------------------------------------------------------------------------------------

// Of the state with the lowest energy: columns of scan.csv and of states.csv.
const Fields& state_columns() {
  static const Fields columns{"model",  "branch", "reduced_volume",     "L",
                              "energy", "class",  "negative_directions"};
  return columns;
}

// stop_reason: of the first state that is not stationary, where there is one.
Fields results_of_states(const fs::path& file) {
  const CsvTable table = read_csv(file);
  std::size_t stationary = 0;
  std::string stop_reason;
  std::optional<std::size_t> lowest;
  for (std::size_t row = 0; row < table.rows.size(); ++row) {
    if (stop_reason.empty() || stop_reason == name(PointStatus::stationary))
      stop_reason = table.text(row, "stop_reason");
    if (table.text(row, "status") != name(PointStatus::stationary)) continue;
    ++stationary;
    if (!lowest || table.number(row, "energy") < table.number(*lowest, "energy")) lowest = row;
  }
  Fields fields{std::to_string(table.rows.size()), std::to_string(stationary)};
  const Fields of_lowest =
      lowest ? fields_of(table, *lowest, state_columns()) : Fields(state_columns().size());
  fields.insert(fields.end(), of_lowest.begin(), of_lowest.end());
  fields.push_back(stop_reason);
  return fields;
}

// ---- a case -------------------------------------------------------------------------------------

Fields result_columns(InputKind kind) {
  Fields columns;
  if (is_evolution(kind)) {
    columns = evolution_columns();
    columns.emplace_back("class");
  } else {
    columns = {"states", "stationary"};
    for (const std::string& column : state_columns()) columns.push_back("lowest_" + column);
  }
  columns.emplace_back("stop_reason");
  return columns;
}

// Empty fields where there is nothing to trust: of cases that have not ended, and of tables that a failure has cut off.
Fields results_of(const SweepPlan& plan, const CaseState& state) {
  Fields none(result_columns(plan.kind).size());
  const bool done = state.status == CaseStatus::done;
  const fs::path file = plan.results_of(state.number);
  if ((!done && state.status != CaseStatus::failed) || !fs::exists(file)) return none;
  try {
    return is_evolution(plan.kind) ? results_of_evolution(file, plan.kind, done)
                                   : results_of_states(file);
  } catch (const std::runtime_error&) {
    if (done) throw;
    return none;
  }
}

// A text without the quotes that it has in files.
std::string bare(const std::string& value) {
  const bool quoted = value.size() >= 2 && value.front() == '"' && value.back() == '"';
  return quoted ? value.substr(1, value.size() - 2) : value;
}

}  // namespace

void write_sweep_table(const SweepPlan& plan) {
  CsvTable table;
  table.columns = {"case", "status"};
  for (const Fields& some : {plan.keys, result_columns(plan.kind), Fields{"reason"}})
    table.columns.insert(table.columns.end(), some.begin(), some.end());
  for (const PlannedCase& of : plan.cases) {
    const CaseState state = state_of(plan, of);
    Fields& row = table.rows.emplace_back();
    row = {std::to_string(of.number), name(state.status)};
    for (const std::string& value : of.values) row.push_back(bare(value));
    const Fields results = results_of(plan, state);
    row.insert(row.end(), results.begin(), results.end());
    row.push_back(state.reason);
  }
  const auto lock = FileLock::wait(plan.folder / ".lock");
  if (lock) write_file(plan.folder / "sweep.csv", text_of(table));
}

}  // namespace sbeh::studies
