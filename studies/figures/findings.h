// What came out, beside what the paper says.
#pragma once

#include "studies/figures/plan.h"
#include "studies/io/csv_table.h"

#include <string>
#include <vector>

namespace sbeh::studies::figures {

enum class Agreement { yes, no, open };  ///< open: the paper does not say, or the runs cannot tell
/// "yes", "no" or "–".
const char* name(Agreement agreement);

struct Finding {
  std::string result;  ///< numbers from the tables
  std::string paper;   ///< what it says of that; empty where it says nothing
  Agreement agreement;
};

/// From the tables of the figures (tables.h); a finding whose numbers are not there is left out.
std::vector<Finding> energy_findings(const CsvTable& energy);
std::vector<Finding> shapes_findings(const CsvTable& shapes);
std::vector<Finding> evolution_findings(const CsvTable& evolution);
std::vector<Finding> measures_findings(const CsvTable& measures);

/// Of the figure, from its table in this folder; none where the table is missing.
std::vector<Finding> findings_of(Figure figure, const std::filesystem::path& folder);

}  // namespace sbeh::studies::figures
