// What kind of shape a generating curve is.
#pragma once

#include "axisym/curve.h"
#include "model/names.h"

#include <vector>

namespace sbeh::axisym {

enum class ShapeClass {
  oblate,       ///< symmetric top to bottom, flatter than wide
  prolate,      ///< symmetric, longer than wide
  stomatocyte,  ///< not symmetric, a pole dented inwards
  pear          ///< not symmetric, both poles outmost
};
constexpr auto names(ShapeClass) { return std::array{"oblate", "prolate", "stomatocyte", "pear"}; }

ShapeClass classify(const Nodes& X);

/// Where the curve comes nearest to the axis, other than at a pole.
struct Neck {
  Eigen::Index node;
  double radius;
  double
      depth;  ///< 1 − radius/R, R that of the less wide part beside it: 0 in a tube, 1 where the neck closes
};
std::vector<Neck> necks(const Nodes& X);

/// The smallest radius at which the curve comes nearest to the axis between the poles; infinite where it has no
/// neck.
double thinnest_neck(const Nodes& X);

/// Whether the curve, taken as the polygon through points spaced a third of the nodes' distance,
/// crosses itself or the axis: the surface would pass through itself.
bool crosses_itself(const Nodes& X);

}  // namespace sbeh::axisym
