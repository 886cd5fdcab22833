// What came out, beside what the paper says.
#pragma once

#include "model/names.h"
#include "studies/figures/tables.h"

#include <string>
#include <vector>

namespace sbeh::studies::figures {

enum class Agreement { yes, no, open };  ///< open: the paper does not say, or the runs cannot tell
constexpr auto names(Agreement) { return std::array{"yes", "no", "–"}; }

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

/// Of the figure, from its table in this folder; none where the table is missing.
std::vector<Finding> findings_of(Figure figure, const std::filesystem::path& folder);

}  // namespace sbeh::studies::figures
