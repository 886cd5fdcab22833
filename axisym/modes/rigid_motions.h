// The motions of a state as a whole, which cost nothing.
#pragma once

#include "axisym/modes/second_variation.h"

#include <vector>

namespace sbeh::axisym {

/// The rigid motions that go with cos mφ as (u, b) of the unknowns of SecondVariation, orthonormal in its mass: the
/// translation along the axis for m = 0, that across and the rotation about an axis across for m = 1. The order stays
/// on its material, b = −(tangential part)·∇β. Without the rotation on a sphere, which moves nothing.
std::vector<Eigen::VectorXd> rigid_motions(const SecondVariation& second, int m);

}  // namespace sbeh::axisym
