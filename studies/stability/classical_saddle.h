// Whether a classical shape is a saddle among all surfaces, by minimisation over spherical harmonics.
#pragma once

#include "axisym/stationary/stationary_case.h"

#include <optional>

namespace sbeh::studies {

struct ClassicalSaddle {
  int negative_directions;  ///< in which the energy falls, at fixed area and volume
  double stiffness;         ///< least second variation, see surface3d/harmonic/minimiser.h
};

/// Empty unless the case is one of SSH without spontaneous curvature, V_r >= 0.65, where the harmonics resolve
/// it.
std::optional<ClassicalSaddle> classical_saddle(const axisym::StationaryCase& of);

}  // namespace sbeh::studies
