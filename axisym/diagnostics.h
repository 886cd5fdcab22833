// What is measured on a state: energy and its parts, geometry, order.
#pragma once

#include "axisym/curve.h"
#include "model/domains.h"
#include "model/energy.h"
#include "model/material.h"

namespace sbeh::axisym {

using model::Energy;

/// Energy of a state whose nodal mean curvature is known.
Energy energy(const model::Material& material, const State& state, const Field& H);

/// H at the north and the south pole, extrapolated from beyond the pole's own element, in which the
/// discrete H is only second-order accurate: the even quartic in arc length that fits the nodes of the
/// next three elements. Needs 8 elements.
std::array<double, 2> pole_curvatures(const Nodes& X, const Field& H);

/// Integrated and extreme values of a state; lengths in radii of the sphere of equal area.
struct Diagnostics {
  Energy energy;
  double area, volume, reduced_volume;
  double W2;  ///< ∫ H dS, −8π on the unit sphere
  double order_min, order_mean, order_max;
  double order_variance;  ///< (1/A)∫(β − mean)² dS
  double order_std;       ///< its root
  model::Domains domains;
  double H_pole;     ///< at the north pole, see pole_curvatures
  double H_rim;      ///< on the widest circle
  double H_abs_max;  ///< largest |H|
  double
      radius_equator;  ///< in the plane of symmetry, of a dumbbell the waist; without one the widest circle's
  double thickness_pole;  ///< distance of the poles along the axis
  double resolution;    ///< largest curvature of the generating curve times the node spacing: above
                        ///< about 0.35 a rim or a neck is not resolved
  double mesh_quality;  ///< shortest over longest element
};
Diagnostics diagnose(const model::Material& material, const State& state);

}  // namespace sbeh::axisym
