// The classical diagram by the finite elements: branches, and the special points between them.
#pragma once

#include "axisym/classical_shape.h"
#include "axisym/options.h"

#include <span>

namespace sbeh::axisym {

/// The shapes of a branch at these reduced volumes, in their order; those of the stomatocytes are the
/// stable ones, beyond the fold. Oblates and prolates are followed from spheroids with V_r = 0.95,
/// stomatocytes from the pitchfork of the oblates over their fold.
/// Throws std::domain_error naming the reduced volume that the branch does not reach.
std::vector<ClassicalShape> element_branch(Branch branch, std::span<const double> reduced_volumes,
                                           const Numerics& numerics);

/// The five special points. The errors are the differences from half as many elements, which
/// overestimate: the energies converge with the sixth power.
SpecialPoints element_special_points(const Numerics& numerics);

}  // namespace sbeh::axisym
