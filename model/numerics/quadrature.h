// Gauss quadrature on the reference interval and the reference triangle.
#pragma once

#include <Eigen/Core>

namespace sbeh::model {

/// Points and weights on [0, 1]; the weights sum to 1.
struct IntervalRule {
  Eigen::VectorXd points;   // n
  Eigen::VectorXd weights;  // n
  int size() const { return int(points.size()); }
};

/// Gauss–Legendre rule with n >= 1 points, exact for polynomials of degree 2n − 1.
/// Throws std::invalid_argument for n < 1.
IntervalRule gauss_rule(int n);

/// Points and weights on the triangle (0,0), (1,0), (0,1); the weights sum to 1/2.
struct TriangleRule {
  Eigen::Matrix2Xd points;  // 2 x n
  Eigen::VectorXd weights;  // n
  int size() const { return int(weights.size()); }
};

/// Conical product of Gauss–Legendre rules, exact for polynomials of the given degree >= 0.
TriangleRule triangle_rule(int degree);

/// 25 points, exact for polynomials of degree 10, which turns and mirrors of the triangle take to each other: all within it, weights
/// positive. Dunavant, Int. J. Numer. Meth. Eng. 21 (1985) 1129, its 14 moment equations solved to all digits of a double.
TriangleRule symmetric_triangle_rule();

}  // namespace sbeh::model
