#include "model/numerics/band_matrix.h"

#include <Eigen/LU>

#include <algorithm>
#include <cassert>
#include <cmath>

namespace sbeh::model {

namespace {

// A column of multipliers is filled up with zeros to whole registers, which may reach beyond the band: into what is not
// used of the column, or zeros times what is.
constexpr int lanes = 8;
using Lanes = Eigen::Array<double, lanes, 1>;
int filled(int count) { return (count + lanes - 1) / lanes * lanes; }

// to −= factor · column, of `count` numbers filled up.
void subtract(double factor, const double* column, int count, double* to) {
  for (int i = 0; i < count; i += lanes)
    Eigen::Map<Lanes>(to + i) -= factor * Eigen::Map<const Lanes>(column + i);
}

}  // namespace

BandMatrix::BandMatrix(int n, int half_width)
    : n_(n),
      width_(half_width),
      storage_(Eigen::MatrixXd::Zero(3 * half_width + 1 + lanes, n)),
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
  int last = 0;  // column that a pivot's row reaches
  Eigen::VectorXd multipliers = Eigen::VectorXd::Zero(filled(width_));
  for (int j = 0; j < n_; ++j) {
    const int below = std::min(width_, n_ - 1 - j);
    auto column = storage_.col(j).segment(2 * width_, below + 1);
    Eigen::Index step = 0;
    if (!(column.cwiseAbs().maxCoeff(&step) > 0)) return false;
    const int pivot = pivots_[std::size_t(j)] = j + int(step);
    std::swap(column[0], column[step]);
    multipliers.head(below) = column.tail(below) / column[0];
    column.tail(below) = multipliers.head(below);
    if (below < width_) multipliers[below] = 0;
    last = std::max(last, std::min(n_ - 1, pivot + width_));
    const auto row_j = [&](int k) { return &(*this)(j, k); };
    // Apart from what follows, which would wait for these numbers to be stored.
    if (step > 0)
      for (int k = j + 1; k <= last; ++k) std::swap(row_j(k)[0], row_j(k)[step]);
    for (int k = j + 1; k <= last; ++k)
      subtract(row_j(k)[0], multipliers.data(), below, row_j(k) + 1);
  }
  return storage_.row(2 * width_).allFinite();  // NaN spreads to the pivots
}

int BandMatrix::determinant_sign() const {
  int sign = 1;
  for (int i = 0; i < n_; ++i) {
    if (storage_(2 * width_, i) < 0) sign = -sign;
    if (pivots_[std::size_t(i)] != i) sign = -sign;
  }
  return sign;
}

void BandMatrix::solve(Eigen::Ref<Eigen::MatrixXd> rhs) const {
  assert(rhs.rows() == n_);
  for (auto x : rhs.colwise()) {
    for (int j = 0; j < n_; ++j) {
      const int below = std::min(width_, n_ - 1 - j);
      std::swap(x[j], x[pivots_[std::size_t(j)]]);
      x.segment(j + 1, below) -= x[j] * storage_.col(j).segment(2 * width_ + 1, below);
    }
    for (int j = n_ - 1; j >= 0; --j) {
      const int above = std::min(2 * width_, j);
      x[j] /= storage_(2 * width_, j);
      x.segment(j - above, above) -= x[j] * storage_.col(j).segment(2 * width_ - above, above);
    }
  }
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
