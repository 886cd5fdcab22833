#include "studies/io/dimension.h"

#include <map>
#include <string>
#include <utility>
#include <vector>

namespace sbeh::studies {

namespace {

using Names = std::vector<std::string_view>;

// δ²F = λ ∫((u/R)² + b²) dS/R², so that eigenvalues are energies and amplitudes of modes have no dimension. The values
// of compare.csv are each of their quantity's dimension and stay as they are; methods.csv has them too.
const std::vector<std::pair<Dimension, Names>>& all_columns() {
  using namespace dimension;
  static const std::vector<std::pair<Dimension, Names>> all{
      {length,
       {"arc_length", "r", "z", "x", "length_1", "length_2", "length_3", "radius_equator",
        "thickness_pole", "W2", "W2_error", "distance", "distance_3d", "distance_from_SSH",
        "SSH_distance", "domain_boundary"}},
      {area, {"area", "domain_area", "spectrum", "contour.mean_square"}},
      {volume, {"volume"}},
      {curvature,
       {"H_pole", "H_rim", "H_abs_max", "H_abs_max_3d", "H_pole_error", "mean_curvature", "H0"}},
      {energy,
       {"energy",
        "energy_distortion",
        "energy_bending",
        "energy_thermotropic",
        "energy_area_difference",
        "energy_error",
        "energy_axisymmetric",
        "energy_end",
        "energy_oblate",
        "energy_prolate",
        "energy_SSH",
        "energy_3d",
        "energy_oblate_k0_0",
        "barrier",
        "bound",
        "eigenvalue",
        "eigenvalue_error",
        "rigid_residual",
        "residual_stiffness",
        "k0",
        "kappa",
        "kappa_gauss"}},
      {tension, {"tension", "potential"}},
      {pressure, {"pressure", "lambda"}},
      {time, {"time", "time_step", "fit_from", "fit_to", "end_time", "unresolved_from"}},
      {rate, {"rate", "rate_error", "rate_difference", "mode_rate", "coarser_rate", "order_speed"}},
      {speed, {"speed_max", "normal_speed"}},
      {power, {"dissipation_friction", "dissipation_order", "dissipation_viscous"}},
      {none,
       {"model",
        "L",
        "L2",
        "L3",
        "flexoelectric",
        "lipid_density",
        "mean_order",
        "reduced_volume",
        "branch",
        "status",
        "order",
        "order_min",
        "order_max",
        "order_mean",
        "order_std",
        "order_variance",
        "order_rim",
        "domains",
        "residual",
        "steps",
        "wall_seconds",
        "seconds",
        "stop_reason",
        "class",
        "negative_directions",
        "negative_directions_3d",
        "self_contact",
        "fold_side",
        "fold_L",
        "fold_L_error",
        "fold_reduced_volume",
        "fold_reduced_volume_error",
        "reduced_volume_error",
        "interfaces",
        "L_error",
        "unstable_modes",
        "kind",
        "first",
        "second",
        "bound_of",
        "m",
        "l",
        "parity",
        "along",
        "error",
        "reason",
        "resolution",
        "jump",
        "energy_balance",
        "mesh_quality",
        "asymmetry",
        "rejected_steps",
        "index",
        "file",
        "frame",
        "event",
        "triangles",
        "min_angle",
        "turn",
        "curvature_gap",
        "energy_change",
        "area_change",
        "volume_change",
        "quantity",
        "relative_difference",
        "first_value",
        "second_value",
        "difference",
        "tolerance",
        "agrees",
        "method",
        "remark",
        "witness",
        "leg",
        "value",
        "neck",
        "energy_reduced",
        "name",
        "verdict",
        "end_state",
        "reduced_rate",
        "amplitude",
        "amplitude_start",
        "amplitude_end",
        "stiffness",
        "below",
        "above",
        "harmonics",
        "number",
        "path",
        "point",
        "from",
        "pass",
        "end",
        "rigid_motions",
        "mean_square",
        "displacement",
        "order_change",
        "energy_displacement",
        "energy_order_change",
        "solver",
        "order_min_radius",
        "order_min_3d",
        "ending",
        "lacks_3d",
        "instant",
        "moment_1",
        "moment_2",
        "moment_3",
        "figure",
        "command",
        "result",
        "paper",
        "agreement",
        "run",
        "at_rest",
        "ended",
        "exit_code",
        "megabytes",
        "cores",
        "checksum"}},
  };
  return all;
}

// "rate" of "rate_m3", "eigenvalue" of "eigenvalue_12".
std::string_view without_number(std::string_view column) {
  const std::size_t digits = column.find_last_not_of("0123456789") + 1;
  const std::string_view name = column.substr(0, digits);
  if (digits < column.size())
    for (const std::string_view end : {"_m", "_"})
      if (name.ends_with(end)) return name.substr(0, digits - end.size());
  return column;
}

}  // namespace

std::optional<Dimension> dimension_of(std::string_view column, std::string_view table) {
  static const auto by_name = [] {
    std::map<std::string_view, Dimension> of;
    for (const auto& [dimension, names] : all_columns())
      for (const std::string_view name : names) of.emplace(name, dimension);
    return of;
  }();
  auto at = by_name.find(std::string(table) + "." + std::string(column));
  if (at == by_name.end()) at = by_name.find(column);
  if (at == by_name.end()) at = by_name.find(without_number(column));
  if (at == by_name.end()) return {};
  return at->second;
}

Dimension dimension_of_key(std::string_view key) {
  using namespace dimension;
  for (const std::string_view of_times : {"end", "output", "frames", "profiles"})
    if (key == of_times) return time;
  if (key == "spontaneous_curvature") return curvature;
  if (key == "fluctuations") return energy;
  if (key == "amplitude") return length;
  return none;
}

}  // namespace sbeh::studies
