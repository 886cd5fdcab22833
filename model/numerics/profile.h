// A meridian: the curve that generates a surface of revolution, with the order on it; polygons in its plane.
#pragma once

#include <Eigen/Core>

namespace sbeh::model {

/// At points from pole to pole.
struct Profile {
  Eigen::Matrix2Xd X;    ///< row 0: r >= 0, 0 at both ends; row 1: z
  Eigen::VectorXd beta;  ///< order there; may be empty where nothing is said of it
};

/// Of P3 elements, each with the nodes 3e … 3e + 3.
inline int element_count(const Eigen::Matrix2Xd& X) { return int(X.cols() - 1) / 3; }

/// Whether two sides of the open polygon that are not neighbours meet. Points are columns.
bool meets_itself(const Eigen::Matrix2Xd& polygon);

}  // namespace sbeh::model
