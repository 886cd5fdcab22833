// The order at which lipids rest on a unit sphere.
#pragma once

#include "model/material.h"

#include <optional>

namespace sbeh::model {

/// Largest β in (0, 1] with (κ'/2)(H − H₀)² + κ_G' K + u' = 0 at H = −2, K = 1 and rising there: the
/// rest state of a uniform order on the unit sphere. Paper's potential: larger root of
/// 60.75β² − 40.5β + 9L = 0. Empty when only the disordered state is left (L > 0.75 there).
std::optional<double> sphere_rest_order(const Material& material);

}  // namespace sbeh::model
