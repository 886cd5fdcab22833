#include "studies/figures/tables.h"

namespace sbeh::studies::figures {

namespace {

Column<EnergyRow> at_rest_column() {
  return {"at_rest",
          [](const EnergyRow& row) { return !row.at_rest ? ""
                                          : *row.at_rest ? "yes"
                                                         : "no"; },
          [](EnergyRow& row, const std::string& field) {
            row.at_rest = field.empty() ? std::nullopt : std::optional(field == "yes");
            return field.empty() || field == "yes" || field == "no";
          }};
}

}  // namespace

const Columns<EnergyRow>& energy_columns() {
  using Row = EnergyRow;
  static const Columns<Row> columns{
      column("solver", &Row::solver),
      column("model", &Row::model),
      column("reduced_volume", &Row::reduced_volume),
      column("L", &Row::L),
      column("triangles", &Row::triangles),
      at_rest_column(),
      column("time", &Row::time),
      column("energy", &Row::energy),
  };
  return columns;
}

const Columns<ShapeRow>& shape_columns() {
  using Row = ShapeRow;
  const auto in_3d = [](std::string name, auto member, const char* format = "{}") {
    return part_column(std::move(name), &Row::in_3d, member, "", format);
  };
  static const Columns<Row> columns{
      column("reduced_volume", &Row::reduced_volume),
      column("L", &Row::L),
      known_column("energy", &Row::energy),
      known_column("energy_SSH", &Row::energy_SSH),
      known_column("order_min", &Row::order_min),
      known_column("order_max", &Row::order_max),
      known_column("H_abs_max", &Row::H_abs_max),
      column("order_min_radius", &Row::order_min_radius, "{:.6g}"),
      column("distance_from_SSH", &Row::distance_from_SSH, "{:.4g}"),
      column("SSH_distance", &Row::SSH_distance, "{:.4g}"),
      in_3d("triangles", &ShapeIn3d::triangles),
      in_3d("time", &ShapeIn3d::time),
      in_3d("ending", &ShapeIn3d::ending),
      in_3d("energy_3d", &ShapeIn3d::energy),
      in_3d("order_min_3d", &ShapeIn3d::order_min),
      in_3d("H_abs_max_3d", &ShapeIn3d::H_abs_max),
      in_3d("distance_3d", &ShapeIn3d::distance, "{:.3g}"),
      in_3d("frame", &ShapeIn3d::frame),
      column("lacks_3d", &Row::lacks),
  };
  return columns;
}

const Columns<CutRow>& cut_columns() {
  using Row = CutRow;
  static const Columns<Row> columns{
      column("model", &Row::model),
      column("solver", &Row::solver),
      column("reduced_volume", &Row::reduced_volume),
      column("L", &Row::L),
      column("x", &Row::x),
      column("z", &Row::z),
      column("order", &Row::order),
  };
  return columns;
}

const Columns<EvolutionRow>& evolution_columns() {
  using Row = EvolutionRow;
  using State = EvolutionState;
  const auto of_state = [](std::string name, auto member, const char* format = "{}") {
    return part_column(std::move(name), &Row::nearest, member, "", format);
  };
  const auto moment = [&](std::size_t k) {
    return of_state(
        fmt::format("moment_{}", k + 1), [k](auto& state) -> auto& { return state.moments[k]; },
        "{:.9g}");
  };
  static const Columns<Row> columns{
      column("model", &Row::model),
      column("residual_stiffness", &Row::residual_stiffness),
      column("instant", &Row::instant),
      of_state("time", &State::time),
      of_state("energy", &State::energy),
      of_state("energy_oblate", &State::energy_oblate),
      of_state("energy_oblate_k0_0", &State::energy_oblate_k0_0),
      of_state("reduced_volume", &State::reduced_volume),
      of_state("order_min", &State::order_min),
      of_state("order_max", &State::order_max),
      of_state("H_abs_max", &State::H_abs_max),
      moment(0),
      moment(1),
      moment(2),
      of_state("frame", &State::frame),
  };
  return columns;
}

const Columns<MeasureRow>& measure_columns() {
  using Row = MeasureRow;
  static const Columns<Row> columns{
      column("model", &Row::model),
      column("residual_stiffness", &Row::residual_stiffness),
      column("unresolved_from", &Row::unresolved_from, "{:.6g}"),
      column("time", &Row::time),
      column("energy", &Row::energy),
      known_column("W2", &Row::W2),
      known_column("order_std", &Row::order_std),
      known_column("order_variance", &Row::order_variance),
      known_column("reduced_volume", &Row::reduced_volume),
      column("ended", &Row::ended),
  };
  return columns;
}

std::vector<std::string> write_tables(Figure figure, const Sources& sources) {
  switch (figure) {
    case Figure::energy:
      return write_energy(sources);
    case Figure::shapes:
      return write_shapes(sources);
    case Figure::evolution:
      return write_evolution(sources);
    case Figure::measures:
      return write_measures(sources);
  }
  return {};
}

}  // namespace sbeh::studies::figures
