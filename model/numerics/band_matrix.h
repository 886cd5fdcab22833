// A band matrix with a dense border, factored by LAPACK: one solve costs O(n) at fixed bandwidth.
#pragma once

#include <Eigen/Core>

#include <vector>

namespace sbeh::model {

/// n x n band matrix A with `half_width` diagonals on either side, in LAPACK's general band storage.
class BandMatrix {
 public:
  BandMatrix(int n, int half_width);

  int size() const { return n_; }
  int half_width() const { return width_; }

  void set_zero() { storage_.setZero(); }
  /// Entry (i, j), |i − j| <= half_width. Valid until factor().
  double& operator()(int i, int j) { return storage_(2 * width_ + i - j, j); }
  double operator()(int i, int j) const { return storage_(2 * width_ + i - j, j); }

  /// Row i becomes that of the identity.
  void set_identity_row(int i);
  /// Row and column i become zero, and `diagonal` where they meet.
  void pin(int i, double diagonal);
  /// += factor · other, of the same shape; before factor().
  void add(double factor, const BandMatrix& other) { storage_ += factor * other.storage_; }
  /// The product with a vector; before factor().
  Eigen::VectorXd times(const Eigen::VectorXd& x) const;

  /// LU with partial pivoting, in place. False when A is singular or not finite.
  [[nodiscard]] bool factor();
  /// Sign of det A, −1 or 1; after factor().
  int determinant_sign() const;
  /// Overwrites the columns of rhs (n x k) with A⁻¹ rhs; after factor().
  void solve(Eigen::Ref<Eigen::MatrixXd> rhs) const;

 private:
  int n_, width_;
  Eigen::MatrixXd storage_;  // (3 half_width + 1) x n
  std::vector<int> pivots_;
};

/// The solution (x, y) of  [A  B; Cᵀ D] (x; y) = (f; g), A factored, B and C n x m, D m x m, m small.
/// Empty x when the Schur complement is singular.
struct BorderedSolution {
  Eigen::VectorXd x;     // n
  Eigen::VectorXd y;     // m
  int determinant_sign;  ///< of the whole matrix, −1 or 1
};
BorderedSolution solve_bordered(const BandMatrix& A, const Eigen::MatrixXd& B,
                                const Eigen::MatrixXd& C, const Eigen::MatrixXd& D,
                                const Eigen::VectorXd& f, const Eigen::VectorXd& g);

}  // namespace sbeh::model
