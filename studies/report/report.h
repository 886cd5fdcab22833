// A folder of results as one page of HTML that needs nothing but itself.
#pragma once

#include "model/names.h"
#include "studies/report/html.h"
#include "studies/report/result_units.h"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace sbeh::studies {

/// What a folder holds, by the command that made it.
enum class ResultsKind { scan, run, relax, seifert, compare, stability, modes, states, diagram };
constexpr auto names(ResultsKind) {
  return std::array{"scan",      "run",   "relax",  "seifert", "compare",
                    "stability", "modes", "states", "diagram"};
}

/// Throws InputError where there is no folder.
void require_folder(const std::filesystem::path& folder);

/// Told by the tables in the folder. Throws InputError, naming what is missing, when it is none.
ResultsKind kind_of_results(const std::filesystem::path& folder);

/// Pictures that `sbeh picture` would draw and that are not there, by their names for its --only.
std::vector<std::string> missing_pictures(const std::filesystem::path& folder, ResultsKind kind);

/// The headline of a page and its numbers that matter most.
struct KeyNumbers {
  std::string title;
  std::vector<html::Fact> facts;
};
/// From the tables in the folder, in physical units where there are some. Throws OutputError (a table is damaged) and
/// InputError (has no rows).
KeyNumbers key_numbers(const std::filesystem::path& folder, ResultsKind kind,
                       const std::optional<ResultUnits>& units = {});

/// What tells a page as a report of this program.
std::string generator_of(std::string_view version);
/// Whether the page would replace an earlier one. Throws OutputError where the file is something else.
bool replaces_report(const std::filesystem::path& file);

struct ReportSummary {
  std::filesystem::path file;
  bool replaced = false;               ///< an earlier report
  bool live = false;                   ///< it can be explored
  std::vector<std::string> missing{};  ///< pictures that are not in it
};

/// Writes report.html into the folder: title, key numbers, pictures and charts, tables, the resolved input
/// and how to run it again. With the `script` of tools/page a page of a kind that has one can be explored (live_data.h). With `units` all numbers but those of the input are
/// physical; the pictures are those of the folder. Replaces an earlier report; throws OutputError when a file of that name is
/// something else, or cannot be written, and what kind_of_results() and key_numbers() throw.
ReportSummary write_report(const std::filesystem::path& folder, std::string_view version,
                           std::string_view script, const std::optional<ResultUnits>& units = {});

}  // namespace sbeh::studies
