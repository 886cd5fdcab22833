// The folder of a sweep as a page: its table, and a small chart for each case, all alike.
#pragma once

#include "studies/report/report.h"

namespace sbeh::studies {

/// Writes report.html into the folder, and sweep.csv as it is now. Cases with results have a chart, evenly spread where there are too many: of an evolution its
/// energy over time, of a scan and of rest states the energies over what changes most in them. Throws as write_report.
ReportSummary write_sweep_report(const std::filesystem::path& folder, std::string_view version);

}  // namespace sbeh::studies
