// Shapes of touching spheres at which the necks of SSH's stationary states close.
#pragma once

#include "axisym/diagnostics.h"
#include "axisym/stationary/limit_shape.h"

#include <array>
#include <optional>
#include <vector>

namespace sbeh::axisym {

/// Those with ideal necks in this material: κ times the mean of the two spheres' H is κH₀ − f − c, c the moment of the
/// area difference (Miao, Seifert, Wortis, Döbereiner, Phys. Rev. E 49, 5389, 1994); where its stiffness is infinite, those of
/// its W₂. One sphere with one or two within it, two beside each other, and chains in which two radii alternate, of `most` spheres.
std::vector<TouchingSpheres> with_ideal_necks(const model::Material& material, int most = 5);

/// To which of these, or of chains of equal spheres, a state with a narrow neck is near in V_r and W₂ both. Empty where none is.
std::optional<TouchingSpheres> closing_shape(const model::Material& material,
                                             const Diagnostics& state);

/// Measures of states on the way to a closed neck of radius a > 0.
struct ClosingMeasures {
  double radius;
  std::vector<double> values;  ///< as many in each
};
struct ClosedMeasures {
  std::vector<double> values, errors;  ///< estimated
};
/// What they tend to, as v + a (α + β ln a) (Fourcade et al., Phys. Rev. E 49, 5276, 1994), by the three with the narrowest necks; the errors
/// are what the three others give differently. Narrowest first, with radii that differ by about a factor of two.
ClosedMeasures with_closed_neck(const std::array<ClosingMeasures, 4>& way);

}  // namespace sbeh::axisym
