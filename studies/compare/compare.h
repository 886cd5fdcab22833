// One case by several independent methods, side by side.
#pragma once

#include "studies/compare/compare_input.h"
#include "studies/io/columns.h"
#include "studies/witnesses/state.h"

namespace sbeh::studies {

/// One quantity of two methods. Two have no values, only the difference: "distance", the largest of either
/// profile's points (of surface3d and harmonics: nodes) from the other curve, which these two do not have
/// from each other, and "history", the largest difference of the energies at equal times, of flow and
/// surface3d alone, or of an evolution.
struct Comparison {
  std::string quantity;
  Witness first, second;
  double first_value = not_known, second_value = not_known;
  double difference = not_known;
  double relative_difference = not_known;  ///< of energies
  std::optional<double> tolerance = {};

  /// What the tolerance is meant for.
  double judged() const;
  /// Whether a tolerance is stated and missed, or cannot be judged.
  bool misses() const;
};

struct CompareSummary {
  std::vector<WitnessState> states;  ///< in the order of the input's methods
  std::vector<Comparison> comparisons;
  bool agrees() const;  ///< every method found its state, no tolerance is missed
};

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

/// histories.csv, of flow and of surface3d from the ellipsoid, or of an evolution.
struct HistoryRow {
  Witness method;
  EnergyAt at;
};
const Columns<HistoryRow>& history_columns();

/// Runs the methods one after the other and leaves run.toml (the input, resolved), compare.csv,
/// methods.csv, profiles.csv (unless of an evolution), histories.csv and, of a 3D run of its own, surface3d.vtu in the folder. A folder that
/// holds results already is refused. Throws InputError, OutputError and Interrupted.
CompareSummary run_compare(const CompareInput& input, const std::filesystem::path& folder,
                           std::string_view version);

/// The summary as tables for people: the values, and the differences from the first method.
std::string table_of(const CompareSummary& summary);

/// A sentence for every method without a state and for every tolerance that is missed.
std::vector<std::string> complaints(const CompareSummary& summary);

}  // namespace sbeh::studies
