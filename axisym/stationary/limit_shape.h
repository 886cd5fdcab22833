// What a branch of SSH tends to where its neck closes: two spheres that touch.
#pragma once

#include "axisym/diagnostics.h"

#include <optional>

namespace sbeh::axisym {

/// Two spheres of together the area of the unit sphere.
struct TwoSpheres {
  double outer, inner;  ///< radii; the larger first
  bool nested;          ///< the smaller within the larger, its outside in
};

/// Those of a reduced volume: R₁² + R₂² = 1, R₁³ ∓ R₂³ = V_r. Empty where there are none: side by side below
/// that of equal ones, and for V_r >= 1.
std::optional<TwoSpheres> two_spheres(double reduced_volume, bool nested);

/// The spontaneous curvature at which a neck between them closes: the mean of their H (Jülicher, Lipowsky,
/// Phys. Rev. E 53, 2670, 1996).
double closing_H0(const TwoSpheres& spheres);

/// Their measures, β = 2/3; nan where there is nothing to be measured.
Diagnostics diagnose(const model::Material& material, const TwoSpheres& spheres);

}  // namespace sbeh::axisym
