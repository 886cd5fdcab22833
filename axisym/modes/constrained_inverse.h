// The inverse of a symmetric matrix among what keeps some linear functions at zero.
#pragma once

#include <Eigen/LU>
#include <Eigen/QR>

namespace sbeh::axisym {

/// A load that resists, b bᵀ/s of a softness s >= 0; with s = 0 bᵀ x stays 0. None where b is empty.
struct SoftConstraint {
  Eigen::VectorXd b{};
  double softness = 0;
};

/// The inverse of A + b bᵀ/s by solve = A⁻¹.
template <class Solve>
class SoftInverse {
 public:
  SoftInverse(const Solve& solve, const SoftConstraint& of) : solve_(solve), b_(of.b) {
    if (b_.size() == 0) return;
    solved_ = solve_(b_);
    schur_ = of.softness + b_.dot(solved_);
  }
  Eigen::VectorXd operator()(const Eigen::VectorXd& load) const {
    Eigen::VectorXd x = solve_(load);
    if (b_.size() > 0) x -= solved_ * (b_.dot(x) / schur_);
    return x;
  }

 private:
  const Solve& solve_;
  Eigen::VectorXd b_, solved_;
  double schur_ = 1;
};

/// x = solve(load + what it takes), so that columnsᵀ x = 0. Columns may depend on each other.
template <class Solve>
class ConstrainedInverse {
 public:
  ConstrainedInverse(const Solve& solve, const Eigen::MatrixXd& columns) : solve_(solve) {
    if (columns.cols() == 0) return;
    Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(columns.colwise().normalized());
    qr.setThreshold(1e-6);
    kept_ = qr.householderQ() * Eigen::MatrixXd::Identity(columns.rows(), qr.rank());
    solved_ = kept_;
    for (auto column : solved_.colwise()) column = solve_(column);
    schur_.compute(kept_.transpose() * solved_);
  }
  Eigen::VectorXd operator()(Eigen::VectorXd load) const {
    if (kept_.cols() == 0) return solve_(load);
    load -= kept_ * (kept_.transpose() * load);  // which moves nothing, but for rounding
    const Eigen::VectorXd x = solve_(load);
    return x - solved_ * schur_.solve(kept_.transpose() * x);
  }

 private:
  const Solve& solve_;
  Eigen::MatrixXd kept_, solved_;  // n x independent columns, made orthonormal, and their solutions
  Eigen::FullPivLU<Eigen::MatrixXd> schur_;
};

}  // namespace sbeh::axisym
