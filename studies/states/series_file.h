// The history of an evolution as a table, series.csv: one line per time. What the columns mean:
// studies/docs/series.md.
#pragma once

#include "model/domains.h"
#include "model/time/flow.h"
#include "studies/io/columns.h"

namespace sbeh::studies {

/// What is known at one time, of either solver; members as in its Diagnostics.
struct SeriesRow {
  model::FlowRecord record;
  double area = not_known, volume = not_known, reduced_volume = not_known, W2 = not_known;
  double order_min = not_known, order_mean = not_known, order_max = not_known;
  double order_variance = not_known, order_std = not_known;
  double H_abs_max = not_known, mesh_quality = not_known;
  model::Domains domains{};
  double asymmetry = not_known;
};

const Columns<SeriesRow>& series_columns();

template <class Diagnostics>
SeriesRow series_row(const model::FlowRecord& record, const Diagnostics& d) {
  SeriesRow row{record,      d.area,         d.volume,    d.reduced_volume, d.W2,
                d.order_min, d.order_mean,   d.order_max, d.order_variance, d.order_std,
                d.H_abs_max, d.mesh_quality, d.domains};
  if constexpr (requires { d.asymmetry; }) row.asymmetry = d.asymmetry;
  return row;
}

}  // namespace sbeh::studies
