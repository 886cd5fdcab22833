#include "studies/report/result_units.h"

#include "axisym/stationary/classical_branches.h"
#include "studies/compare/compare_input.h"
#include "studies/evolution/relax_input.h"
#include "studies/evolution/run_input.h"
#include "studies/io/conventions.h"
#include "studies/io/output.h"
#include "studies/modes/modes_input.h"
#include "studies/parameters/input_kind.h"
#include "studies/report/report.h"
#include "studies/rest_states/states_input.h"
#include "studies/scan/scan_input.h"
#include "studies/stability/stability_input.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>

namespace sbeh::studies {

namespace fs = std::filesystem;

namespace {

std::string text_of(const Units& units) {
  TomlText toml("");
  write_units(toml, units);
  return toml.text().substr(toml.text().find('[') - 1);
}

// Of a state, and of a grid.
DescribedUnits one_state(const auto& input) { return {input.units, Physics(input)}; }
DescribedUnits one_case(const auto& input) {
  return {input.units, {input.state.model, input.state.material}};
}
DescribedUnits grid(const auto& input) {
  return {input.units, {input.models.front(), input.material}, true};
}

// The classical diagram has no run.toml: κ = 1.
DescribedUnits described_results(const fs::path& folder) {
  if (const auto kind = kind_of_results(folder);
      kind == ResultsKind::seifert || kind == ResultsKind::diagram)
    return {{}, {model::Model::SSH, axisym::classical_material()}};
  return described_units(folder / "run.toml");
}

Units units_from(const fs::path& folder, const DescribedUnits& described,
                 const std::optional<fs::path>& from) {
  if (!from && described.units) return *described.units;
  if (!from)
    throw InputError(fmt::format(
        "{}: has no [units] in its run.toml: name a file that has them with --units-from",
        folder.string()));
  if (const auto units = read_units(TomlFile::parse(*from))) return *units;
  throw InputError(fmt::format("{}: has no table [units]", from->string()));
}

// L of "points/SBEH_oblate_v0.7_L0.05.csv".
std::optional<double> L_in_name(const fs::path& file) {
  const std::string text = file.string();
  const std::size_t at = text.rfind("_L");
  if (at == std::string::npos) return {};
  const std::size_t from = at + 2;
  for (std::size_t count = text.size() - from; count > 0; --count)
    if (double L = 0; parse_number(std::string_view(text).substr(from, count), L) && L > 0)
      return L;
  return {};
}

bool needs_energy(const Dimension& d) { return d.energy != 0 || d.time != 0; }

std::string times(const std::string& field, double factor) {
  double value = 0;
  if (!parse_number(field, value) || !std::isfinite(value)) return field;
  return converted_number(value, factor);
}

std::vector<Dimension> dimensions_of(const CsvTable& table, const fs::path& file) {
  std::vector<Dimension> dimensions;
  for (const std::string& column : table.columns) {
    const auto dimension = dimension_of(column, file.stem().string());
    if (!dimension)
      throw OutputError(fmt::format("{}: is no table of results: its column '{}' is not known",
                                    file.string(), column));
    dimensions.push_back(*dimension);
  }
  return dimensions;
}

// Results must not be taken for converted tables, nor be lost to them.
void require_own_folder(const fs::path& into, const fs::path& note, bool overwrite) {
  std::error_code none;
  if (fs::exists(note, none) && !fs::exists(into / "run.toml", none)) {
    if (overwrite) return;
    throw OutputError(fmt::format(
        "{}: is there already: choose another folder, or give --overwrite", note.string()));
  }
  if (fs::exists(into, none) && !fs::is_empty(into, none))
    throw OutputError(fmt::format(
        "{}: holds other files than converted tables: choose another folder", into.string()));
}

std::vector<fs::path> tables_in(const fs::path& folder, const fs::path& without) {
  std::vector<fs::path> files;
  for (auto at = fs::recursive_directory_iterator(folder); at != fs::end(at); ++at) {
    std::error_code ignored;
    if (at->is_directory() && fs::equivalent(at->path(), without, ignored))
      at.disable_recursion_pending();
    else if (at->path().extension() == ".csv")
      files.push_back(at->path());
  }
  std::ranges::sort(files);
  return files;
}

}  // namespace

std::string converted_number(double value, double factor) {
  return fmt::format("{:.15g}", factor * value);
}

DescribedUnits described_units(const fs::path& input) {
  switch (kind_of(input)) {
    case InputKind::scan:
      return grid(read_scan(input));
    case InputKind::stability:
      return grid(read_stability(input));
    case InputKind::relax:
      return one_state(read_relax(input));
    case InputKind::run:
      return one_state(read_run(input));
    case InputKind::compare:
      return one_case(read_compare(input));
    case InputKind::diagram:
    case InputKind::sweep:
      return {};
    case InputKind::states: {
      const StatesInput states = read_states(input);
      return {states.units, {states.model, states.material}, true};
    }
    case InputKind::modes: {
      const ModesInput modes = read_modes(input);
      DescribedUnits described = one_case(modes);
      described.thermal_energy = modes.thermal_energy;
      return described;
    }
  }
  return {};
}

ResultUnits::ResultUnits(const fs::path& folder, const std::optional<fs::path>& from)
    : described_(described_results(folder)), units_(units_from(folder, described_, from)) {
  require_scales();
}

ResultUnits::ResultUnits(DescribedUnits described, const Units& units)
    : described_(std::move(described)), units_(units) {
  require_scales();
}

void ResultUnits::require_scales() const {
  try {
    scales(any_L());
  } catch (const std::invalid_argument& error) {
    throw InputError(error.what());
  }
}

Scales ResultUnits::scales(std::optional<double> L) const {
  const Physics& physics = described_.physics;
  if (L) return scales_of(units_, physics.material.with_L1(*L), physics.model);
  return by_L() ? *lengths_of(units_) : scales_of(units_, physics.material, physics.model);
}

std::string ResultUnits::titled(std::string_view name, const Dimension& dimension) const {
  if (dimension == dimension::none) return std::string(name);
  return fmt::format("{} ({})", name, unit(dimension));
}

std::string ResultUnits::other_temperature() const {
  if (described_.thermal_energy == 0) return "";
  const double thermal = described_.thermal_energy * *scales().energy / units_.thermal();
  if (std::abs(thermal - 1) < 1e-6) return "";
  return fmt::format(
      "fluctuations are those of a thermal energy of {:.6g} k_BT at {:.6g} K: those of 1 k_BT have "
      "fluctuations = \"1 kT\" in [modes]",
      thermal, units_.temperature);
}

std::vector<std::string> ResultUnits::text() const {
  if (by_L()) {
    std::vector<std::string> lines = studies::text_of(units_, scales(0.05), " where L = 0.05");
    lines.emplace_back(
        "κ and R are the same in all rows: each has its own E₀ = κ/(2L + k₀), and T");
    return lines;
  }
  std::vector<std::string> lines = studies::text_of(units_, scales());
  if (const std::string other = other_temperature(); !other.empty()) lines.push_back(other);
  return lines;
}

// At a fold, the state is that of the fold's L.
Scales ResultUnits::scales_of_row(const CsvTable& table, std::size_t row) const {
  double L = table.number(row, table.text(row, "fold_side") == "at" ? "fold_L" : "L");
  if (std::isnan(L)) L = table.number(row, "L");
  return L > 0 ? scales(L) : scales();
}

bool ResultUnits::rows_have_own(const CsvTable& table, const fs::path& file) const {
  return by_L() && table.find("L") && std::ranges::any_of(dimensions_of(table, file), needs_energy);
}

CsvTable ResultUnits::values(const CsvTable& table, const fs::path& file) const {
  const std::vector<Dimension> dimensions = dimensions_of(table, file);
  const bool have_own = rows_have_own(table, file);
  const Scales common = scales(by_L() ? L_in_name(file) : std::nullopt);
  if (!have_own && !common.energy && std::ranges::any_of(dimensions, needs_energy))
    throw OutputError(fmt::format("{}: of which L it is, is not known", file.string()));
  CsvTable result = table;
  for (std::size_t row = 0; row < table.rows.size(); ++row) {
    const Scales of = have_own ? scales_of_row(table, row) : common;
    for (std::size_t k = 0; k < dimensions.size(); ++k) {
      std::string& field = result.rows[row][k];
      if (needs_energy(dimensions[k]) && !of.energy)
        field.clear();
      else if (dimensions[k] != dimension::none)
        field = times(field, of.factor(dimensions[k]));
    }
  }
  return result;
}

CsvTable ResultUnits::converted(const CsvTable& table, const fs::path& file) const {
  const std::vector<Dimension> dimensions = dimensions_of(table, file);
  const Scales names = scales(any_L());
  CsvTable result = values(table, file);
  for (std::size_t k = 0; k < dimensions.size(); ++k)
    result.columns[k] += names.suffix(dimensions[k]);
  if (!rows_have_own(table, file)) return result;
  result.columns.push_back("unit_energy" + names.suffix(dimension::energy));
  if (names.time) result.columns.emplace_back("unit_time_s");
  for (std::size_t row = 0; row < table.rows.size(); ++row) {
    const Scales of = scales_of_row(table, row);
    auto& fields = result.rows[row];
    fields.push_back(of.energy ? times("1", of.factor(dimension::energy)) : "");
    if (names.time) fields.push_back(of.time ? times("1", *of.time) : "");
  }
  return result;
}

ConvertedTables write_converted(const fs::path& folder, const ResultUnits& units,
                                const fs::path& into, bool overwrite, std::string_view version) {
  const fs::path note = into / "units.toml";
  require_own_folder(into, note, overwrite);
  make_folder(into);
  std::string how = fmt::format(
      "# sbeh {}: the tables of {} in physical units, which end the names of columns;\n"
      "# columns without are pure numbers.\n",
      version, folder.string());
  for (const std::string& line : units.text()) how += "# " + line + "\n";
  for (const char* line : std::span(conventions).subspan(1)) how += fmt::format("# {}\n", line);
  write_file(note, how + text_of(units.units()));
  ConvertedTables written;
  for (const fs::path& file : tables_in(folder, into)) {
    const fs::path name = file.lexically_relative(folder);
    std::string text;
    try {
      text = text_of(units.converted(read_csv(file), name));
    } catch (const OutputError& error) {
      written.left.emplace_back(error.what());
      continue;
    }
    make_folder((into / name).parent_path());
    write_file(into / name, text);
    ++written.count;
  }
  return written;
}

}  // namespace sbeh::studies
