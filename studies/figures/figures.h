// The paper's figures from their inputs: the runs that are missing, tables, and what came out.
#pragma once

#include "model/names.h"
#include "studies/figures/tables.h"

namespace sbeh::studies::figures {

struct Request {
  std::vector<Figure> figures;
  std::filesystem::path folder;  ///< of the results
  std::filesystem::path inputs;
  std::optional<int> triangles;
  bool draw_only = false;  ///< run nothing
};

struct Summary {
  /// What a figure lacks, by figure as asked for; a phrase for each.
  std::vector<std::pair<Figure, std::vector<std::string>>> missing;
  std::vector<std::string> failed;  ///< runs made now that ended before their time, and why
  std::vector<std::string>
      unresolved;            ///< those that their triangles did not resolve, and from when
  bool interrupted = false;  ///< then there are no new tables
};

/// Makes the scan and the 3D runs that are not there or not finished, each in its folder (plan.h), then the
/// tables (tables.h), and figures.csv, a row for each finding of every figure whose table is there. Progress on standard error. Throws InputError and
/// OutputError.
Summary make_figures(const Request& request, std::string_view version);

// ---- what came out, beside what the paper says --------------------------------------------------

enum class Agreement { yes, no, open };  ///< open: the paper does not say, or the runs cannot tell
constexpr auto names(Agreement) { return std::array{"yes", "no", "–"}; }
inline Agreement agrees(bool it_does) { return it_does ? Agreement::yes : Agreement::no; }

struct Finding {
  std::string result;  ///< numbers from the tables
  std::string paper;   ///< what it says of that; empty where it says nothing
  Agreement agreement;
};

/// From the tables of the figures (tables.h); a finding whose numbers are not there is left out.
std::vector<Finding> energy_findings(const std::vector<EnergyRow>& energy);
std::vector<Finding> shapes_findings(const std::vector<ShapeRow>& shapes);
std::vector<Finding> evolution_findings(const std::vector<EvolutionRow>& evolution);
std::vector<Finding> measures_findings(const std::vector<MeasureRow>& measures);

/// A row of figures.csv.
struct FigureRow {
  int figure;
  std::string command;
  double seconds;  ///< of the runs; `not_known` where none was made here
  Finding finding;
};
const Columns<FigureRow>& figure_columns();

/// The rows for the screen.
std::string text_of(const std::vector<FigureRow>& figures);

}  // namespace sbeh::studies::figures
