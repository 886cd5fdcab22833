// Lagrange elements of order 1 to 3 on the reference interval and the reference triangle.
#pragma once

#include <Eigen/Core>

namespace sbeh::model {

/// Equidistant Lagrange element of the given order on [0, 1]; nodes in order from 0 to 1.
class IntervalElement {
 public:
  /// order 1 … 3; throws std::invalid_argument otherwise.
  explicit IntervalElement(int order);
  int order() const { return order_; }
  int size() const { return order_ + 1; }

  Eigen::VectorXd nodes() const;                // size
  Eigen::VectorXd values(double x) const;       // size: φ_i(x)
  Eigen::VectorXd derivatives(double x) const;  // size: φ_i'(x)

 private:
  int order_;
};

/// Lagrange element of the given order on the triangle (0,0), (1,0), (0,1).
/// Node order: corners 0 1 2; then edge 0→1, edge 1→2, edge 2→0 (each from its first corner on);
/// then the interior. The same as VTK's Lagrange triangle.
class TriangleElement {
 public:
  /// order 1 … 3; throws std::invalid_argument otherwise.
  explicit TriangleElement(int order);
  int order() const { return order_; }
  int size() const { return (order_ + 1) * (order_ + 2) / 2; }

  Eigen::Matrix2Xd nodes() const;                                // 2 x size
  Eigen::VectorXd values(const Eigen::Vector2d& x) const;        // size
  Eigen::Matrix2Xd derivatives(const Eigen::Vector2d& x) const;  // 2 x size: ∂_1, ∂_2
  Eigen::Matrix3Xd second_derivatives(
      const Eigen::Vector2d& x) const;  // 3 x size: ∂_1∂_1, ∂_1∂_2, ∂_2∂_2

 private:
  int order_;
};

}  // namespace sbeh::model
