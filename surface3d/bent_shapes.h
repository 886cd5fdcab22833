// Shape functions with second derivatives, at the points where a triangle's Gaussian energy is summed.
#pragma once

#include "surface3d/surface.h"

#include <array>
#include <vector>

namespace sbeh::surface3d {

/// Shape functions at a point, with second derivatives: ∂_1∂_1, ∂_1∂_2.
struct BentShapes : ShapeValues {
  std::array<std::array<double, 10>, 2> ddphi;
};
using BentPoints = std::vector<BentShapes>;

/// Of degree 10: those of the assembly.
const BentPoints& inner_points();
/// On two sides, (0, 0) to (0, 1) and (1, 0) to (0, 1), weights summing to 1.
const BentPoints& first_rim();
const BentPoints& second_rim();

}  // namespace sbeh::surface3d
