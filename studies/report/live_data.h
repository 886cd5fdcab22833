// The data of live pages, from a folder of results: tables as they are, shapes in 16 bits.
#pragma once

#include "studies/report/bundle.h"
#include "studies/report/report.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace sbeh::studies {

// With units the numbers of the tables are physical, and units.csv has name, unit and factor: of each column that has a unit, the factor where
// it is the same in all rows; and of H and speed, which shapes have as in the files.

/// Of a scan: its tables, `folder`, where it is, and its profiles by the rows of scan.csv (packed_profiles.h). Of points whose modes `sbeh modes` has
/// left in modes/NAME, NAME being that of their files, also
///   point_modes.csv   modes.csv of each after `row`, that of scan.csv
///   mode_shapes       (packed_fields.h) r, z, order, u and b by the row and the mode, "4/m2_even_1"
/// Throws OutputError where a table or a profile is damaged, and InputError where modes are those of another state.
Bundle live_scan(const std::filesystem::path& folder, const std::optional<ResultUnits>& units = {});

// Of an evolution: series.csv, charts.csv (history_charts.h), `states`, how many the folder has, and shown.csv, a row per state that is shown: time, file.
// Where there are more than a page can hold they are as many as it can, evenly spread. Throws OutputError and InputError
// where a table or a state is damaged.

/// In 3D: shown.csv also says which mesh a state has, and there is a film (packed_film.h) with order, H and speed.
Bundle live_run(const std::filesystem::path& folder, const std::optional<ResultUnits>& units = {});
/// Axisymmetric: the profiles by the rows of shown.csv.
Bundle live_relax(const std::filesystem::path& folder,
                  const std::optional<ResultUnits>& units = {});

/// Of the modes of a state: modes.csv, and the table of each mode, modes/m2_even_1.csv …, that is there.
Bundle live_modes(const std::filesystem::path& folder,
                  const std::optional<ResultUnits>& units = {});

/// Of rest states in 3D: states.csv; shown.csv, number and mesh of each whose frame is there (as many as a page can hold, evenly spread); a film
/// of these (packed_film.h) with order and H; and mode_shapes (packed_fields.h), u and b by number and eigenpair, "3/1", scaled as in mode_file.h.
/// Throws OutputError and InputError where a file is damaged.
Bundle live_states(const std::filesystem::path& folder,
                   const std::optional<ResultUnits>& units = {});

/// Adds a table of the folder in these units.
void add_table(Bundle& bundle, const std::filesystem::path& folder, const std::string& name,
               const std::optional<ResultUnits>& units);
void add_units(Bundle& bundle, const std::optional<ResultUnits>& units,
               const std::vector<std::string>& columns);

/// The text of a file without the last line where that is not whole: it may be half written.
std::string whole_lines(const std::filesystem::path& file);

/// Which kinds of results have a live page.
bool has_live_page(ResultsKind kind);
/// Why results of such a kind are too many for one; empty where they are not.
std::string too_many_for_a_page(const std::filesystem::path& folder, ResultsKind kind);
/// Of a kind that has one.
Bundle live_data(const std::filesystem::path& folder, ResultsKind kind,
                 const std::optional<ResultUnits>& units = {});

}  // namespace sbeh::studies
