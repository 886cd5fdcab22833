// Newton's method for stationary points of a function at fixed measures.
#pragma once

#include <Eigen/QR>

#include <functional>

namespace sbeh::model {

/// Orthonormal coordinates: first the normal ones, along the gradients of what is fixed, then the
/// tangential ones, which leave it alone to first order.
class TangentSplit {
 public:
  /// n x m: the gradient of each of the m measures.
  explicit TangentSplit(const Eigen::MatrixXd& gradients);

  /// A symmetric n x n matrix in these coordinates.
  Eigen::MatrixXd rotated(Eigen::MatrixXd H) const;
  /// Tangential coordinates.
  Eigen::VectorXd tangential(const Eigen::VectorXd& v) const;
  /// Ascending eigenvalues of the tangential block of a rotated matrix.
  Eigen::VectorXd tangential_eigenvalues(const Eigen::MatrixXd& rotated) const;

  /// The solution of H x = force, be it approximate.
  using Solve =
      std::function<Eigen::VectorXd(const Eigen::MatrixXd& H, const Eigen::VectorXd& force)>;
  /// The step (n, as it is) that takes the misses of the measures away, and their Lagrangian's gradient, by
  /// its rotated Hessian.
  Eigen::VectorXd newton_step(const Eigen::MatrixXd& rotated_hessian,
                              const Eigen::VectorXd& gradient, const Eigen::VectorXd& miss,
                              const Solve& solve) const;

 private:
  Eigen::Index normal_, tangential_;
  Eigen::HouseholderQR<Eigen::MatrixXd> qr_;
};

}  // namespace sbeh::model
