#include "studies/states/series_file.h"

namespace sbeh::studies {

using model::Dissipation;
using model::Energy;
using model::FlowRecord;

const Columns<SeriesRow>& series_columns() {
  using Row = SeriesRow;
  const auto of_record = [](std::string name, auto... members) {
    return column<Row>(std::move(name), inside(&Row::record, members...));
  };
  static const Columns<Row> columns{
      of_record("time", &FlowRecord::time),
      of_record("time_step", &FlowRecord::time_step),
      derived_column<Row>(
          "energy", [](const Row& row) { return fmt::format("{}", row.record.energy.total()); }),
      of_record("energy_distortion", &FlowRecord::energy, &Energy::distortion),
      of_record("energy_bending", &FlowRecord::energy, &Energy::bending),
      of_record("energy_thermotropic", &FlowRecord::energy, &Energy::thermotropic),
      of_record("energy_area_difference", &FlowRecord::energy, &Energy::area_difference),
      of_record("dissipation_friction", &FlowRecord::dissipation, &Dissipation::friction),
      of_record("dissipation_order", &FlowRecord::dissipation, &Dissipation::order),
      of_record("dissipation_viscous", &FlowRecord::dissipation, &Dissipation::viscous),
      of_record("energy_balance", &FlowRecord::energy_balance),
      column("area", &Row::area),
      column("volume", &Row::volume),
      column("reduced_volume", &Row::reduced_volume),
      column("W2", &Row::W2),
      column("order_min", &Row::order_min),
      column("order_mean", &Row::order_mean),
      column("order_max", &Row::order_max),
      column("order_variance", &Row::order_variance),
      column("order_std", &Row::order_std),
      column<Row>("domains", inside(&Row::domains, &model::Domains::count)),
      column<Row>("domain_area", inside(&Row::domains, &model::Domains::area)),
      column<Row>("domain_boundary", inside(&Row::domains, &model::Domains::boundary)),
      column("H_abs_max", &Row::H_abs_max),
      of_record("speed_max", &FlowRecord::speed_max),
      of_record("lambda", &FlowRecord::lambda),
      column("mesh_quality", &Row::mesh_quality),
      known_column("asymmetry", &Row::asymmetry),
      of_record("rejected_steps", &FlowRecord::rejected),
  };
  return columns;
}

}  // namespace sbeh::studies
