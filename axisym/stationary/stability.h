// Stability of a stationary state within axisymmetric shapes.
#pragma once

#include "axisym/stationary/lagrangian.h"

namespace sbeh::axisym {

/// Number of independent directions (of shape and order, area and volume kept, translations left out)
/// in which the energy falls to second order: 0 for a local minimum. It is the number of negative
/// eigenvalues of the matrix of the Lagrangian with all its multipliers, less the number of
/// multipliers, counted by a block LDLᵀ factorisation (Sylvester's law of inertia); O(elements).
int negative_directions(const LagrangianDerivatives& lagrangian, const model::Material& material,
                        model::Model model);
int negative_directions(const model::Material& material, model::Model model,
                        const StationaryState& state);

}  // namespace sbeh::axisym
