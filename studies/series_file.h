// The history of an evolution as a table: one line per time.
#pragma once

#include "axisym/flow.h"

#include <string>
#include <vector>

namespace sbeh::studies {

/// What is known at one time.
struct SeriesRow {
  axisym::FlowRecord record;
  axisym::Diagnostics diagnostics;
};

/// The names of the columns, comma separated, as in series.csv of every run.
std::string series_header();
/// One line in these columns, numbers with all their digits.
std::string series_line(const SeriesRow& row);
/// Header and lines.
std::string series_text(const std::vector<SeriesRow>& rows);

}  // namespace sbeh::studies
