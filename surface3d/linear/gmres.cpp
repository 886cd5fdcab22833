#include "surface3d/linear/gmres.h"

#include "surface3d/linear/in_parallel.h"

#include <Eigen/Jacobi>

#include <algorithm>
#include <cmath>
#include <vector>

namespace sbeh::surface3d {

Eigen::VectorXd product(const SparseMatrix& A, const Eigen::VectorXd& x) {
  constexpr Eigen::Index rows = 256;
  Eigen::VectorXd y(A.rows());
  in_parallel(int((A.rows() + rows - 1) / rows), [&](int block) {
    const Eigen::Index first = block * rows, count = std::min(rows, A.rows() - first);
    y.segment(first, count).noalias() = A.middleRows(first, count) * x;
  });
  return y;
}

// Without restart: Saad and Schultz 1986, modified Gram–Schmidt and Givens rotations.
int Gmres::solve(const std::function<Eigen::VectorXd(const Eigen::VectorXd&)>& A,
                 const Eigen::VectorXd& b, Eigen::VectorXd& x) const {
  const auto preconditioned = [this](Eigen::VectorXd v) {
    direct_.solve(v);
    return v;
  };
  std::vector<Eigen::VectorXd> basis{preconditioned(b - A(x))};
  const double start = basis[0].norm(), size = x.norm() > 0 ? x.norm() : start;
  const double enough =
      std::min(tolerance_ * size, std::max(reduction * tolerance_ * start, floor * size));
  if (!std::isfinite(start)) return 0;
  if (start <= enough) return x += basis[0], 1;
  basis[0] /= start;
  Eigen::MatrixXd R = Eigen::MatrixXd::Zero(most_iterations + 1, most_iterations);
  Eigen::VectorXd residual = Eigen::VectorXd::Zero(most_iterations + 1);
  residual[0] = start;
  std::vector<Eigen::JacobiRotation<double>> rotations;
  for (int k = 0; k < most_iterations; ++k) {
    Eigen::VectorXd next = preconditioned(A(basis[std::size_t(k)]));
    for (int i = 0; i <= k; ++i) {
      R(i, k) = basis[std::size_t(i)].dot(next);
      next -= R(i, k) * basis[std::size_t(i)];
    }
    R(k + 1, k) = next.norm();
    if (!std::isfinite(R(k + 1, k))) return 0;
    const double length = R(k + 1, k);
    for (int i = 0; i < k; ++i)
      R.col(k).applyOnTheLeft(i, i + 1, rotations[std::size_t(i)].adjoint());
    rotations.emplace_back();
    rotations.back().makeGivens(R(k, k), R(k + 1, k));
    R.col(k).applyOnTheLeft(k, k + 1, rotations.back().adjoint());
    residual.applyOnTheLeft(k, k + 1, rotations.back().adjoint());
    if (std::abs(residual[k + 1]) <= enough || length == 0) {
      const Eigen::VectorXd y =
          R.topLeftCorner(k + 1, k + 1).triangularView<Eigen::Upper>().solve(residual.head(k + 1));
      for (int i = 0; i <= k; ++i) x += y[i] * basis[std::size_t(i)];
      return k + 2;
    }
    basis.emplace_back(next / length);
  }
  return 0;
}

double Gmres::cost_of_factoring() const {
  // Measured: dense kernels of the factorisation run eight times as fast as the solve, which waits for
  // memory; a multiplication by the matrix comes on top of each.
  constexpr double speed_ratio = 8;
  return direct_.flops() / (2 * direct_.entries()) / speed_ratio;
}

}  // namespace sbeh::surface3d
