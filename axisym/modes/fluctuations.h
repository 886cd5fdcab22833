// Thermal fluctuations of a state that is stable, to second order in the energy.
//
// A mode of amplitude a, ∫(u² + b²) cos² mφ dS = 1, costs λa²/2, so that ⟨a²⟩ = k_BT/λ; for m ≥ 1 its turn by a quarter
// of a wave, sin mφ, fluctuates as much and independently.
#pragma once

#include "axisym/modes/second_variation.h"

#include <optional>

namespace sbeh::axisym {

/// ⟨a_m²⟩/(k_BT) of the widest circle's radius R + Σ_m (a_m cos mφ + b_m sin mφ), ⟨b_m²⟩ being the same for m ≥ 1: from all
/// modes of m, not the lowest alone, but rigid motions, to which they are orthogonal in ∫(u u' + b b') dS; for m = 0 area
/// and volume are kept. It means something only where all eigenvalues of m are positive. Empty where it is not found: where one is
/// 0 or nearly so.
std::optional<double> contour_variance(const SecondVariation& second, int m);

}  // namespace sbeh::axisym
