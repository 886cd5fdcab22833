// Polygons in the plane.
#pragma once

#include <Eigen/Core>

namespace sbeh::model {

/// Whether two sides of the open polygon that are not neighbours meet. Points are columns.
bool meets_itself(const Eigen::Matrix2Xd& polygon);

}  // namespace sbeh::model
