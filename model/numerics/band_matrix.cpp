#include "model/numerics/band_matrix.h"

#include <Eigen/LU>
#include <lapacke.h>

#include <algorithm>
#include <cassert>

extern "C" void openblas_set_num_threads(int);

namespace sbeh::model {

namespace {
// On bands as narrow as ours OpenBLAS's own threads only wait for each other.
const bool one_thread = (openblas_set_num_threads(1), true);
}  // namespace

BandMatrix::BandMatrix(int n, int half_width)
    : n_(n),
      width_(half_width),
      storage_(Eigen::MatrixXd::Zero(3 * half_width + 1, n)),
      pivots_(std::size_t(n)) {}

void BandMatrix::set_identity_row(int i) {
  for (int j = std::max(0, i - width_); j <= std::min(n_ - 1, i + width_); ++j)
    (*this)(i, j) = i == j ? 1 : 0;
}

void BandMatrix::pin(int i, double diagonal) {
  for (int j = std::max(0, i - width_); j <= std::min(n_ - 1, i + width_); ++j)
    (*this)(i, j) = (*this)(j, i) = i == j ? diagonal : 0;
}

Eigen::VectorXd BandMatrix::times(const Eigen::VectorXd& x) const {
  Eigen::VectorXd y = Eigen::VectorXd::Zero(n_);
  for (int j = 0; j < n_; ++j) {
    const int first = std::max(0, j - width_), last = std::min(n_ - 1, j + width_);
    y.segment(first, last - first + 1) +=
        x[j] * storage_.col(j).segment(2 * width_ + first - j, last - first + 1);
  }
  return y;
}

bool BandMatrix::factor() {
  const int info = LAPACKE_dgbtrf_work(LAPACK_COL_MAJOR, n_, n_, width_, width_, storage_.data(),
                                       int(storage_.rows()), pivots_.data());
  return info == 0 && storage_.row(2 * width_).allFinite();  // NaN spreads to the pivots
}

int BandMatrix::determinant_sign() const {
  int sign = 1;
  for (int i = 0; i < n_; ++i) {
    if (storage_(2 * width_, i) < 0) sign = -sign;
    if (pivots_[std::size_t(i)] != i + 1) sign = -sign;  // LAPACK counts from 1
  }
  return sign;
}

void BandMatrix::solve(Eigen::Ref<Eigen::MatrixXd> rhs) const {
  assert(rhs.rows() == n_);
  LAPACKE_dgbtrs_work(LAPACK_COL_MAJOR, 'N', n_, width_, width_, int(rhs.cols()), storage_.data(),
                      int(storage_.rows()), pivots_.data(), rhs.data(), int(rhs.outerStride()));
}

BorderedSolution solve_bordered(const BandMatrix& A, const Eigen::MatrixXd& B,
                                const Eigen::MatrixXd& C, const Eigen::MatrixXd& D,
                                const Eigen::VectorXd& f, const Eigen::VectorXd& g) {
  const Eigen::Index m = B.cols();
  Eigen::MatrixXd columns(A.size(), m + 1);  // A⁻¹ (B, f)
  columns << B, f;
  A.solve(columns);
  if (m == 0) return {columns.col(0), Eigen::VectorXd(0), A.determinant_sign()};
  const Eigen::FullPivLU<Eigen::MatrixXd> schur(D - C.transpose() * columns.leftCols(m));
  if (!schur.isInvertible()) return {};
  const Eigen::VectorXd y = schur.solve(g - C.transpose() * columns.col(m));
  return {columns.col(m) - columns.leftCols(m) * y, y,
          schur.determinant() < 0 ? -A.determinant_sign() : A.determinant_sign()};
}

}  // namespace sbeh::model
