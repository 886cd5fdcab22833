#include "studies/stability/stability_table.h"

namespace sbeh::studies {

const Columns<StabilityResult>& stability_columns() {
  using Row = StabilityResult;
  using Key = StabilityKey;
  using model::Model;
  static const Columns<Row> columns{
      column<Row>("model", inside(&Row::key, &Key::model)),
      column<Row>("reduced_volume", inside(&Row::key, &Key::reduced_volume)),
      column<Row>("L", inside(&Row::key, &Key::L)),
      column<Row>("branch", inside(&Row::key, &Key::branch)),
      column<Row>("l", inside(&Row::key, &Key::l)),
      column<Row>("m", inside(&Row::key, &Key::m)),
      column("verdict", &Row::verdict),
      column("end_state", &Row::end_state),
      part_column("rate", &Row::growth, &GrowthRate::rate, ""),
      part_column("rate_error", &Row::growth, &GrowthRate::error, "", "{:.3g}"),
      part_column("fit_from", &Row::growth, &GrowthRate::from, ""),
      part_column("fit_to", &Row::growth, &GrowthRate::to, ""),
      known_column("reduced_rate", &Row::reduced_rate),
      known_column("amplitude_start", &Row::amplitude_start),
      known_column("amplitude_end", &Row::amplitude_end),
      known_column("energy_axisymmetric", &Row::energy_axisymmetric),
      known_column("energy_end", &Row::energy_end),
      known_column("energy_oblate", &Row::energy_oblate),
      known_column("energy_prolate", &Row::energy_prolate),
      column("end_time", &Row::end_time),
      column("steps", &Row::steps),
      column("triangles", &Row::triangles),
      column("unresolved_from", &Row::unresolved_from),
      column("negative_directions", &Row::negative_directions),
      known_column("stiffness", &Row::stiffness),
      column("wall_seconds", &Row::wall_seconds, "{:.4g}"),
      column("stop_reason", &Row::stop_reason),
  };
  return columns;
}

StabilityTable stability_table(const OutputFolder& folder) {
  return {folder / "stability.csv", stability_columns(), "studies of stability",
          "its run made again"};
}

const Columns<PerturbedAt>& perturbed_columns() {
  static const Columns<PerturbedAt> columns{
      column("time", &PerturbedAt::time),
      column("time_step", &PerturbedAt::time_step),
      column("energy", &PerturbedAt::energy),
      column("amplitude", &PerturbedAt::amplitude),
      column("normal_speed", &PerturbedAt::normal_speed),
      column("order_speed", &PerturbedAt::order_speed),
  };
  return columns;
}

}  // namespace sbeh::studies
