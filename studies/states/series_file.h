// The history of an evolution as a table, series.csv: one line per time. What the columns mean:
// studies/docs/series.md.
#pragma once

#include "model/time/flow.h"
#include "studies/io/columns.h"

namespace sbeh::studies {

/// What is known at one time, of either solver.
struct SeriesRow {
  model::FlowRecord record;
  model::Diagnostics diagnostics;  ///< but for the energy, which is the record's
};

const Columns<SeriesRow>& series_columns();

}  // namespace sbeh::studies
