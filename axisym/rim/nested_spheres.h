// What the ordered stomatocytes tend to beyond their fold: a sphere within a sphere, on a neck that has closed.
//
// No state but a limit. At a neck of radius a the order melts: the bending (9L/4)∫β²|B|² of a catenoid of that size,
// 18πLβ², is saved for a distortion of 2(2πL/3)/ln(√L/a), which vanishes with a. So nothing holds the neck open, and the
// energy falls to that of two spheres, each with a uniform order ("Closing necks" in model/equations.md).
#pragma once

#include "axisym/rim/beyond_fold.h"

namespace sbeh::axisym {

/// The radii of the two spheres: R₁² + R₂² = 1, R₁³ − R₂³ = V_r.
struct NestedRadii {
  double outer, inner;
};
/// Throws std::invalid_argument unless 0 < V_r < 1.
NestedRadii nested_radii(double reduced_volume);

/// Per area, of a sphere of radius R with the uniform order in [0, 1] that costs least; `inside` if the membrane's outward
/// normal points to its centre.
struct OrderedSphere {
  double order, energy;
};
OrderedSphere ordered_sphere(const model::Material& material, double R, bool inside);

/// The limit at one point, in the one-constant approximation: the energies of both spheres, and no resolution, stability
/// or curvature at the neck. Throws std::invalid_argument unless 0 < V_r < 1.
RimRecord nested_spheres(const model::Material& material, double reduced_volume, double L);

}  // namespace sbeh::axisym
