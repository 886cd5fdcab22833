// How finely a shape is meshed.
#pragma once

#include "meshing/point_group.h"

namespace sbeh::meshing {

/// Of a closed surface.
inline constexpr int fewest_triangles = 20, most_triangles = 200'000;

struct Resolution {
  int triangles = 1280;  ///< about so many; 20 n² where the sphere's mesh fits
  int order = 3;         ///< 1, 2 or 3
  double grading = 0;  ///< 0 … 10: how much smaller triangles are where |H| is large, see `smooth`
  PointGroup symmetry = {};  ///< of shape and triangles; C1: triangles of the icosahedron
  /// Cubic nodes off a shape that a formula gives, so that its triangles are nearest to it, see `fit`; else on it.
  bool fitted = false;
  /// Throws std::invalid_argument unless 20 <= triangles <= 200000 and the others are as above.
  void validate() const;
};

}  // namespace sbeh::meshing
