// The inverse of a symmetric matrix among what keeps some linear functions at zero.
#pragma once

#include <Eigen/LU>
#include <Eigen/QR>

namespace sbeh::axisym {

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
