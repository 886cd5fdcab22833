// The tables that a comparison leaves.
#include "studies/compare/compare.h"

namespace sbeh::studies {

namespace {

Column<WitnessState> status_column() {
  return {
      "status",
      [](const WitnessState& row) { return std::string(row.failure.empty() ? "found" : "failed"); },
      [](WitnessState& row, const std::string& field) {
        row.failure = field == "failed" ? field : "";
        return field == "failed" || field == "found";
      }};
}

// After the status, which says what it is.
Column<WitnessState> remark_column() {
  return {"remark",
          [](const WitnessState& row) {
            return csv_field(row.failure.empty() ? row.remark : row.failure);
          },
          [](WitnessState& row, const std::string& field) {
            (row.failure.empty() ? row.remark : row.failure) = field;
            return true;
          }};
}

}  // namespace

const Columns<Comparison>& comparison_columns() {
  using Row = Comparison;
  static const Columns<Row> columns{
      column("quantity", &Row::quantity),
      column("first", &Row::first),
      column("second", &Row::second),
      known_column("first_value", &Row::first_value),
      known_column("second_value", &Row::second_value),
      known_column("difference", &Row::difference),
      known_column("relative_difference", &Row::relative_difference),
      column("tolerance", &Row::tolerance),
      derived_column<Row>("agrees",
                          [](const Row& row) {
                            return !row.tolerance ? "" : row.misses() ? "no" : "yes";
                          }),
  };
  return columns;
}

const Columns<WitnessState>& method_columns() {
  using Row = WitnessState;
  static const Columns<Row> columns = [] {
    Columns<Row> all{column("method", &Row::witness), status_column()};
    for (const Quantity& quantity : quantities())
      all.push_back(known_column<Row>(quantity.name, inside(&Row::measures, quantity.value)));
    all.push_back(column("seconds", &Row::seconds, "{:.4g}"));
    all.push_back(remark_column());
    return all;
  }();
  return columns;
}

const Columns<PlacedPoint>& placed_columns() {
  using Row = PlacedPoint;
  static const Columns<Row> columns{
      column("method", &Row::method), column("arc_length", &Row::arc_length),
      column("r", &Row::r),           column("z", &Row::z),
      column("order", &Row::order),   column("distance", &Row::distance),
  };
  return columns;
}

const Columns<HistoryRow>& history_columns() {
  using Row = HistoryRow;
  static const Columns<Row> columns{
      column("method", &Row::method),
      column<Row>("time", inside(&Row::at, &EnergyAt::time)),
      column<Row>("energy", inside(&Row::at, &EnergyAt::energy)),
  };
  return columns;
}

}  // namespace sbeh::studies
