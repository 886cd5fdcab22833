#include "studies/states/series_file.h"

namespace sbeh::studies {

using model::Diagnostics;
using model::Dissipation;
using model::Energy;
using model::FlowRecord;

const Columns<SeriesRow>& series_columns() {
  using Row = SeriesRow;
  const auto of_record = [](std::string name, auto... members) {
    return column<Row>(std::move(name), inside(&Row::record, members...));
  };
  const auto measured = [](std::string name, double Diagnostics::*member) {
    return column<Row>(std::move(name), inside(&Row::diagnostics, member));
  };
  static const Columns<Row> columns{
      of_record("time", &FlowRecord::time),
      of_record("time_step", &FlowRecord::time_step),
      derived_column<Row>(
          "energy", [](const Row& row) { return fmt::format("{}", row.record.energy.total()); }),
      of_record("energy_distortion", &FlowRecord::energy, &Energy::distortion),
      of_record("energy_bending", &FlowRecord::energy, &Energy::bending),
      of_record("energy_thermotropic", &FlowRecord::energy, &Energy::thermotropic),
      of_record("dissipation_friction", &FlowRecord::dissipation, &Dissipation::friction),
      of_record("dissipation_order", &FlowRecord::dissipation, &Dissipation::order),
      of_record("dissipation_viscous", &FlowRecord::dissipation, &Dissipation::viscous),
      of_record("energy_balance", &FlowRecord::energy_balance),
      measured("area", &Diagnostics::area),
      measured("volume", &Diagnostics::volume),
      measured("reduced_volume", &Diagnostics::reduced_volume),
      measured("W2", &Diagnostics::W2),
      measured("order_min", &Diagnostics::order_min),
      measured("order_mean", &Diagnostics::order_mean),
      measured("order_max", &Diagnostics::order_max),
      measured("order_variance", &Diagnostics::order_variance),
      measured("order_std", &Diagnostics::order_std),
      measured("H_abs_max", &Diagnostics::H_abs_max),
      of_record("speed_max", &FlowRecord::speed_max),
      of_record("lambda", &FlowRecord::lambda),
      measured("mesh_quality", &Diagnostics::mesh_quality),
      of_record("rejected_steps", &FlowRecord::rejected),
  };
  return columns;
}

}  // namespace sbeh::studies
