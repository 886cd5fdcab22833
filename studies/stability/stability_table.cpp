#include "studies/stability/stability_table.h"

#include "studies/io/csv_line.h"
#include "studies/io/csv_table.h"
#include "studies/parameters/material_input.h"
#include "studies/witnesses/state.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace sbeh::studies {

namespace {

constexpr const char* header =
    "model,reduced_volume,L,branch,l,m,verdict,end_state,rate,rate_error,fit_from,fit_to,"
    "reduced_rate,amplitude_start,amplitude_end,energy_axisymmetric,energy_end,energy_oblate,"
    "energy_prolate,end_time,steps,triangles,unresolved_from,negative_directions,stiffness,"
    "wall_seconds,stop_reason";

template <class T>
std::string optional_field(const std::optional<T>& value) {
  return value ? fmt::format("{}", *value) : "";
}
std::string known_field(double value) { return std::isnan(value) ? "" : fmt::format("{}", value); }

std::string line_of(const StabilityResult& row) {
  const StabilityKey& k = row.key;
  std::string line = fmt::format("{},{},{},{},{},{},{},{}", model::name(k.model), k.reduced_volume,
                                 k.L, name(k.branch), k.l, k.m, name(row.verdict), row.end_state);
  line += row.growth ? fmt::format(",{},{:.3g},{},{}", row.growth->rate, row.growth->error,
                                   row.growth->from, row.growth->to)
                     : ",,,,";
  for (const double value :
       {row.reduced_rate, row.amplitude_start, row.amplitude_end, row.energy_axisymmetric,
        row.energy_end, row.energy_oblate, row.energy_prolate})
    line += fmt::format(",{}", known_field(value));
  return line
       + fmt::format(",{},{},{},{},{},{},{:.4g},{}", row.end_time, row.steps, row.triangles,
                     optional_field(row.unresolved_from), optional_field(row.negative_directions),
                     known_field(row.stiffness), row.wall_seconds, csv_field(row.stop_reason));
}

std::optional<double> number_in(const CsvTable& table, std::size_t row, const char* column) {
  double value = 0;
  if (!parse_number(table.text(row, column), value)) return {};
  return value;
}

// Empty where the row is damaged.
std::optional<StabilityResult> row_of(const CsvTable& table, std::size_t row) {
  const auto known = [&](const char* column) {
    return number_in(table, row, column).value_or(not_known);
  };
  StabilityResult result;
  const auto model = model::value_named<model::Model>(table.text(row, "model"));
  const auto branch = model::value_named<axisym::Branch>(table.text(row, "branch"));
  const auto verdict = model::value_named<Verdict>(table.text(row, "verdict"));
  const auto v = number_in(table, row, "reduced_volume"), L = number_in(table, row, "L"),
             l = number_in(table, row, "l"), m = number_in(table, row, "m");
  if (!model || !branch || !verdict || !v || !L || !l || !m) return {};
  result.key = {*v, *L, *model, *branch, int(*l), int(*m)};
  result.verdict = *verdict;
  result.end_state = table.text(row, "end_state");
  if (number_in(table, row, "rate"))
    result.growth = GrowthRate{.rate = known("rate"),
                               .error = known("rate_error"),
                               .from = known("fit_from"),
                               .to = known("fit_to")};
  result.reduced_rate = known("reduced_rate");
  result.amplitude_start = known("amplitude_start");
  result.amplitude_end = known("amplitude_end");
  result.energy_axisymmetric = known("energy_axisymmetric");
  result.energy_end = known("energy_end");
  result.energy_oblate = known("energy_oblate");
  result.energy_prolate = known("energy_prolate");
  result.end_time = known("end_time");
  result.steps = int(number_in(table, row, "steps").value_or(0));
  result.triangles = int(number_in(table, row, "triangles").value_or(0));
  result.unresolved_from = number_in(table, row, "unresolved_from");
  if (const auto count = number_in(table, row, "negative_directions"))
    result.negative_directions = int(*count);
  result.stiffness = known("stiffness");
  result.wall_seconds = known("wall_seconds");
  result.stop_reason = table.text(row, "stop_reason");
  return result;
}

}  // namespace

StabilityTable::StabilityTable(const OutputFolder& folder) : path_(folder / "stability.csv") {
  if (!std::filesystem::exists(path_)) {
    write_file(path_, std::string(header) + "\n");
  } else {
    const std::string text = read_file(path_);
    if (text.substr(0, text.find('\n')) != header)
      throw OutputError(
          fmt::format("{}: is no table of this version's studies of stability; choose another "
                      "folder with -o or move the old one away",
                      path_.string()));
    const CsvTable table = read_csv(path_);
    for (std::size_t row = 0; row < table.rows.size(); ++row) {
      const auto result = row_of(table, row);
      if (!result)
        throw OutputError(
            fmt::format("{}:{}: is damaged; delete that line to have its run made again",
                        path_.string(), row + 2));
      rows_.insert_or_assign(result->key, *result);
    }
    sort();
  }
  file_.emplace(path_);
}

void StabilityTable::append(const StabilityResult& row) {
  file_->append(line_of(row));
  rows_.insert_or_assign(row.key, row);
}

void StabilityTable::sort() {
  file_.reset();
  std::string text = std::string(header) + "\n";
  for (const auto& [key, row] : rows_) text += line_of(row) + "\n";
  write_file(path_, text);
  file_.emplace(path_);
}

std::string history_text(const std::vector<PerturbedAt>& history) {
  std::string text = "time,time_step,energy,amplitude,normal_speed,order_speed\n";
  for (const PerturbedAt& at : history)
    text += fmt::format("{},{},{},{},{},{}\n", at.time, at.time_step, at.energy, at.amplitude,
                        at.normal_speed, at.order_speed);
  return text;
}

}  // namespace sbeh::studies
