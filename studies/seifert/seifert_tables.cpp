#include "studies/seifert/seifert_tables.h"

namespace sbeh::studies {

using axisym::ClassicalShape;
using axisym::SpecialPoint;

namespace {

// Empty where the witness does not tell.
Column<BranchRow> negative_directions() {
  return {"negative_directions",
          [](const BranchRow& row) {
            const int count = row.shape.negative_directions;
            return count < 0 ? "" : std::to_string(count);
          },
          [](BranchRow& row, const std::string& field) {
            return field.empty() || read_field(row.shape.negative_directions, field);
          }};
}

}  // namespace

const Columns<BranchRow>& branch_columns() {
  using Row = BranchRow;
  const auto of_shape = [](std::string name, auto member) {
    return column<Row>(std::move(name), inside(&Row::shape, member));
  };
  static const Columns<Row> columns{
      column("witness", &Row::witness),
      column<Row>("branch", inside(&Row::shape, &ClassicalShape::branch)),
      of_shape("reduced_volume", &ClassicalShape::reduced_volume),
      of_shape("energy_reduced", &ClassicalShape::energy),
      of_shape("H_pole", &ClassicalShape::H_pole),
      of_shape("pressure", &ClassicalShape::pressure),
      of_shape("tension", &ClassicalShape::tension),
      negative_directions(),
      of_shape("self_contact", &ClassicalShape::self_contact),
  };
  return columns;
}

const Columns<PointRow>& point_columns() {
  using Row = PointRow;
  static const Columns<Row> columns{
      column("name", &Row::name),
      column<Row>("reduced_volume", inside(&Row::point, &SpecialPoint::reduced_volume)),
      column<Row>("energy_reduced", inside(&Row::point, &SpecialPoint::energy)),
      column<Row>("error", inside(&Row::point, &SpecialPoint::error), "{:.2g}"),
  };
  return columns;
}

const Columns<PointRow>& witness_point_columns() {
  static const Columns<PointRow> columns = [] {
    Columns<PointRow> all = point_columns();
    all.insert(all.begin(), column("witness", &PointRow::witness));
    return all;
  }();
  return columns;
}

const Columns<Disagreement>& disagreement_columns() {
  using Row = Disagreement;
  static const Columns<Row> columns{
      column("first", &Row::first),
      column("second", &Row::second),
      column("branch", &Row::branch),
      column("energy_reduced", &Row::energy, "{:.3g}"),
      column("H_pole", &Row::H_pole, "{:.3g}"),
      column("pressure", &Row::pressure, "{:.3g}"),
      column("tension", &Row::tension, "{:.3g}"),
  };
  return columns;
}

}  // namespace sbeh::studies
