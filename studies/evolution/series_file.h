// The history of an evolution as a table: one line per time.
#pragma once

#include "axisym/flow.h"
#include "surface3d/diagnostics.h"

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
std::string series_line(const model::FlowRecord& record, const axisym::Diagnostics& diagnostics);
std::string series_line(const model::FlowRecord& record, const surface3d::Diagnostics& diagnostics);
inline std::string series_line(const SeriesRow& row) {
  return series_line(row.record, row.diagnostics);
}
/// Header and lines.
std::string series_text(const std::vector<SeriesRow>& rows);

}  // namespace sbeh::studies
