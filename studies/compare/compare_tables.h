// The tables that a comparison leaves.
#pragma once

#include "studies/compare/compare.h"
#include "studies/io/columns.h"

namespace sbeh::studies {

/// compare.csv: a row per quantity and pair of methods; `agrees` is yes, no, or empty where no tolerance is
/// stated.
const Columns<Comparison>& comparison_columns();

/// methods.csv: a row per method; `status` is found or failed, `remark` then the reason.
const Columns<WitnessState>& method_columns();

/// profiles.csv: a point of a method's meridian, or of surface3d and harmonics a node.
struct PlacedPoint {
  Witness method;
  double arc_length;  ///< of the nearest point of the first method's curve
  double r, z, order;
  double distance;  ///< from that curve along its outward normal; 0 for the first method itself
};
const Columns<PlacedPoint>& placed_columns();

/// histories.csv, of flow and of surface3d from the ellipsoid.
struct HistoryRow {
  Witness method;
  EnergyAt at;
};
const Columns<HistoryRow>& history_columns();

}  // namespace sbeh::studies
