// A folder of results in physical units: of which vesicle it is, and its tables converted.
#pragma once

#include "studies/io/csv.h"
#include "studies/parameters/physics.h"
#include "studies/parameters/units.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace sbeh::studies {

/// What an input or a run.toml says of the units of its numbers.
struct DescribedUnits {
  std::optional<Units> units{};
  Physics physics{};
  bool many_L = false;        ///< a grid: L of `physics` is not that of its states
  double thermal_energy = 0;  ///< of fluctuations
};
/// Throws InputError.
DescribedUnits described_units(const std::filesystem::path& input);

/// The units of results. States of one κ and R that differ in L differ in E₀ and T.
class ResultUnits {
 public:
  /// Of a folder; its own [units], or those of the file `from`. Throws InputError where there are none, or where they do not fit.
  explicit ResultUnits(const std::filesystem::path& folder,
                       const std::optional<std::filesystem::path>& from = {});

  /// Of an input. Throws InputError where they do not fit.
  ResultUnits(DescribedUnits described, const Units& units);

  const Units& units() const { return units_; }
  /// Whether rows have units of their own, by their L.
  bool by_L() const { return described_.many_L; }
  /// Of states with that L; without, only the length is known where rows have their own.
  Scales scales(std::optional<double> L = {}) const;

  /// "kT", the same for all rows.
  std::string unit(const Dimension& dimension) const { return scales(any_L()).unit(dimension); }
  /// "energy (kT)"; the name alone of a pure number.
  std::string titled(std::string_view name, const Dimension& dimension) const;

  /// A sentence where fluctuations are of another thermal energy than that of these units.
  std::string other_temperature() const;

  /// A line for each scale, or how rows have theirs.
  std::vector<std::string> text() const;

  /// The table in physical units, its columns named as before. `file`, relative to the folder, tells which table it is, and of
  /// which L where its name does. Throws OutputError for a column that is not known.
  CsvTable values(const CsvTable& table, const std::filesystem::path& file) const;

  /// The same with the units in the names of its columns, and where rows have their own, what 1 of energy and time are in columns
  /// unit_energy_… and unit_time_s.
  CsvTable converted(const CsvTable& table, const std::filesystem::path& file) const;

 private:
  /// Where rows have their own: whose names of units are those of all.
  std::optional<double> any_L() const { return by_L() ? std::optional(1.) : std::nullopt; }
  void require_scales() const;
  bool rows_have_own(const CsvTable& table, const std::filesystem::path& file) const;
  Scales scales_of_row(const CsvTable& table, std::size_t row) const;

  DescribedUnits described_;
  Units units_;
};

/// A number of a table times the factor of its unit, as converted tables have it: 15 digits.
std::string converted_number(double value, double factor);

struct ConvertedTables {
  int count = 0;
  std::vector<std::string> left;  ///< files that are no tables of results, with the reason
};
/// Writes all tables of the folder, converted, under their names into `into`, and units.toml, which says how. Throws
/// OutputError where that is there already and may not be overwritten, and where `into` holds anything else.
ConvertedTables write_converted(const std::filesystem::path& folder, const ResultUnits& units,
                                const std::filesystem::path& into, bool overwrite,
                                std::string_view version);

}  // namespace sbeh::studies
