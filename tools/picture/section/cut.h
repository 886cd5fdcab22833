// The closed cross section of an axisymmetric shape.
#pragma once

#include "axisym/curve.h"
#include "tools/picture/canvas/geometry.h"

#include <vector>

namespace sbeh::picture {

/// The cross section in a plane through the axis: closed (first point = last point) and centred in z.
struct Cut {
  Points points;              ///< (±r, z)
  std::vector<double> order;  ///< β at each point
  double half_width = 0.0;
  double half_height = 0.0;
};

Cut mirrored(const axisym::State& profile);

/// Only the points a picture can show: those farther apart than `spacing`, or where the curve turns.
Cut thinned(const Cut& cut, double spacing);

}  // namespace sbeh::picture
