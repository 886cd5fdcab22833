// The order of a start as a formula of the place.
#pragma once

#include <Eigen/Core>

#include <string>

namespace sbeh::studies {

/// Values of a formula of muparser's language (+ − * / ^, comparisons, a ? b : c, sin, tanh, exp, sqrt, min, max …, pi) at places that are
/// seen from the centre of the surface (3 x places). Its variables: x, y, z, the distance r from the z axis, theta from it and phi about it;
/// on a surface of revolution z, r and theta. Throws std::invalid_argument: what is wrong with it, and where.
Eigen::VectorXd values_of_formula(const std::string& formula, bool of_revolution,
                                  const Eigen::Matrix3Xd& places);

}  // namespace sbeh::studies
