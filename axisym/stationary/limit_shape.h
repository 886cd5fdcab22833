// What a branch of SSH tends to where its necks close: spheres that touch.
#pragma once

#include "axisym/diagnostics.h"

#include <optional>
#include <vector>

namespace sbeh::axisym {

/// Spheres of together the area of the unit sphere.
struct TouchingSpheres {
  std::vector<double> radii;  ///< the largest first
  bool nested;                ///< the others within the first, their outsides in; else a chain
};

/// Those of a reduced volume 0 < V_r < 1: R₁² + R₂² = 1, R₁³ − R₂³ = V_r.
TouchingSpheres sphere_in_sphere(double reduced_volume);

/// Two beside each other, of 1/√2 <= V_r < 1: R₁² + R₂² = 1, R₁³ + R₂³ = V_r; empty below.
std::optional<TouchingSpheres> sphere_beside_sphere(double reduced_volume);

/// So many equal ones, of V_r = 1/√count: symmetric shapes with all necks closed.
TouchingSpheres chain_of_spheres(int count);

/// The spontaneous curvature at which the neck between the first two closes: the mean of their H (Jülicher, Lipowsky,
/// Phys. Rev. E 53, 2670, 1996).
double closing_H0(const TouchingSpheres& spheres);

/// Their measures, β = 2/3; nan where there is nothing to be measured.
Diagnostics diagnose(const model::Material& material, const TouchingSpheres& spheres);

}  // namespace sbeh::axisym
