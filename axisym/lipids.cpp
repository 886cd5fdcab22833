#include "axisym/lipids.h"

#include <cmath>

namespace sbeh::axisym {

double lipid_area(const model::Material& material, const State& state) {
  if (!material.has_lipid_density()) return area(state.X);
  double sum = 0;
  for_each_point(state.X, assembly_points(), [&](int e, const ShapeValues& s, const CurvePoint& p) {
    sum += p.dS * material.packing(value_at(state.beta, e, s));
  });
  return sum;
}

bool correct_lipids_volume(const model::Material& material, const model::Target& target,
                           State& state) {
  if (!material.has_lipid_density())
    return correct_area_volume(state.X, target.area, target.volume);
  constexpr int most_steps = 20;
  for (int step = 0; step < most_steps; ++step) {
    const double now = lipid_area(material, state), miss = target.area - now;
    const bool is_met = std::abs(miss) < 1e-12 * target.area;
    if (!correct_area_volume(state.X, area(state.X) * (1 + miss / now), target.volume))
      return false;
    if (is_met) return true;
  }
  return false;
}

double OrderRate::at(int e, const ShapeValues& s, const CurvePoint& p) const {
  double along = 0;
  for (int a = 0; a < 4; ++a) along += s.phi[a] * slip.col(3 * e + a).dot(p.t);
  return value_at(change, e, s) + along * slope_at(beta, e, s) / p.stretch;
}

Field lipid_load(const model::Material& material, const State& old, const OrderRate& rate) {
  Field load = Field::Zero(2 * element_count(old.X) + 1);
  for_each_point(old.X, assembly_points(), [&](int e, const ShapeValues& s, const CurvePoint& p) {
    const double slope = material.packing_slope(value_at(old.beta, e, s));
    const double flux = p.dS * slope * rate.at(e, s, p);
    for (int k = 0; k < 3; ++k) load[2 * e + k] += flux * s.phi2[std::size_t(k)];
  });
  return load;
}

}  // namespace sbeh::axisym
