// sweep.csv: inputs and results of all cases.
#include "studies/io/csv.h"
#include "studies/io/file_lock.h"
#include "studies/io/output.h"
#include "studies/scan/scan_table.h"
#include "studies/sweep/sweep_status.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace sbeh::studies {

namespace fs = std::filesystem;

namespace {

using Fields = std::vector<std::string>;

// Of the last row of a history: columns of series.csv.
const Fields& evolution_columns() {
  static const Fields columns{
      "time",           "energy",   "energy_distortion", "energy_bending", "energy_thermotropic",
      "reduced_volume", "W2",       "order_min",         "order_mean",     "order_max",
      "H_abs_max",      "speed_max"};
  return columns;
}

// Of the state with the lowest energy: columns of scan.csv and of states.csv.
const Fields& state_columns() {
  static const Fields columns{"model",  "branch", "reduced_volume",     "L",
                              "energy", "class",  "negative_directions"};
  return columns;
}

bool is_evolution(InputKind kind) { return kind == InputKind::run || kind == InputKind::relax; }

Fields result_columns(InputKind kind) {
  if (is_evolution(kind)) return evolution_columns();
  Fields columns{"states", "stationary"};
  for (const std::string& column : state_columns()) columns.push_back("lowest_" + column);
  return columns;
}

// As they stand in the table, bit for bit.
Fields fields_of(const CsvTable& table, std::size_t row, const Fields& columns) {
  Fields fields;
  for (const std::string& column : columns) fields.push_back(table.text(row, column));
  return fields;
}

Fields results_of_states(const CsvTable& table) {
  std::size_t stationary = 0;
  std::optional<std::size_t> lowest;
  for (std::size_t row = 0; row < table.rows.size(); ++row) {
    if (table.text(row, "status") != name(PointStatus::stationary)) continue;
    ++stationary;
    if (!lowest || table.number(row, "energy") < table.number(*lowest, "energy")) lowest = row;
  }
  Fields fields{std::to_string(table.rows.size()), std::to_string(stationary)};
  const Fields of_lowest =
      lowest ? fields_of(table, *lowest, state_columns()) : Fields(state_columns().size());
  fields.insert(fields.end(), of_lowest.begin(), of_lowest.end());
  return fields;
}

Fields results_in(const fs::path& file, InputKind kind) {
  Fields none(result_columns(kind).size());
  if (!fs::exists(file)) return none;
  const CsvTable table = read_csv(file);
  if (table.rows.empty()) return none;
  return is_evolution(kind) ? fields_of(table, table.rows.size() - 1, evolution_columns())
                            : results_of_states(table);
}

// Empty fields where there is nothing to trust: of cases that have not ended, and of tables that a failure has cut off.
Fields results_of(const SweepPlan& plan, const CaseState& state) {
  Fields none(result_columns(plan.kind).size());
  if (state.status == CaseStatus::done) return results_in(plan.results_of(state.number), plan.kind);
  if (state.status != CaseStatus::failed) return none;
  try {
    return results_in(plan.results_of(state.number), plan.kind);
  } catch (const OutputError&) {
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
