#include "studies/evolution/series_file.h"

#include <fmt/format.h>

namespace sbeh::studies {

std::string series_header() {
  return "time,time_step,energy,energy_distortion,energy_bending,energy_thermotropic,"
         "dissipation_friction,dissipation_order,dissipation_viscous,energy_balance,area,volume,"
         "reduced_volume,W2,order_min,order_mean,order_max,order_variance,order_std,H_abs_max,"
         "speed_max,lambda,mesh_quality,rejected_steps";
}

namespace {

// Both solvers' diagnostics have these members.
template <class Diagnostics>
std::string line_of(const model::FlowRecord& r, const Diagnostics& d) {
  return fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{}",
                     r.time, r.time_step, r.energy.total(), r.energy.distortion, r.energy.bending,
                     r.energy.thermotropic, r.dissipation.friction, r.dissipation.order,
                     r.dissipation.viscous, r.energy_balance, d.area, d.volume, d.reduced_volume,
                     d.W2, d.order_min, d.order_mean, d.order_max, d.order_variance, d.order_std,
                     d.H_abs_max, r.speed_max, r.lambda, d.mesh_quality, r.rejected);
}

}  // namespace

std::string series_line(const model::FlowRecord& r, const axisym::Diagnostics& d) {
  return line_of(r, d);
}
std::string series_line(const model::FlowRecord& r, const surface3d::Diagnostics& d) {
  return line_of(r, d);
}

std::string series_text(const std::vector<SeriesRow>& rows) {
  std::string text = series_header() + "\n";
  for (const SeriesRow& row : rows) text += series_line(row) + "\n";
  return text;
}

}  // namespace sbeh::studies
