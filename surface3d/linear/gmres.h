// GMRES with the factors of an earlier matrix.
#pragma once

#include "surface3d/linear/direct_solver.h"

#include <functional>

namespace sbeh::surface3d {

/// A x on all threads.
Eigen::VectorXd product(const SparseMatrix& A, const Eigen::VectorXd& x);

/// Solves A x = b by GMRES with the factors of an earlier matrix as left preconditioner, so that the
/// residual measures the error of the solution. The factors are in single precision unless the tolerance
/// is below `coarse`. Where several ranks share it each has a part of A, as in DirectSolver.
class Gmres {
 public:
  Gmres(Symmetry symmetry, double tolerance, const Ranks& ranks = {})
      : direct_(symmetry, tolerance < coarse ? Precision::full : Precision::single, ranks),
        ranks_(ranks),
        tolerance_(tolerance) {}

  [[nodiscard]] bool factor(const SparseMatrix& A) { return direct_.factor(A); }

  /// Improves the guess x, which may be 0, until the preconditioned residual is `tolerance` of x; and
  /// where the guess is good, `reduction` times the tolerance of that of the guess, but no less than
  /// `floor` of x. Returns the number of times the factors were applied; 0 when `most_iterations` did not
  /// suffice, and then x is as it was.
  int solve(const SparseMatrix& A, const Eigen::VectorXd& b, Eigen::VectorXd& x) const {
    return solve(
        [&](const Eigen::VectorXd& v) {
          Eigen::VectorXd part = product(A, v);
          ranks_.sum({part.data(), std::size_t(part.size())});
          return part;
        },
        b, x);
  }
  /// The same with A as what it makes of a vector.
  int solve(const std::function<Eigen::VectorXd(const Eigen::VectorXd&)>& A,
            const Eigen::VectorXd& b, Eigen::VectorXd& x) const;

  /// What a factorisation costs, in applications of its factors.
  double cost_of_factoring() const;
  /// See DirectSolver.
  int negative_eigenvalues() const { return direct_.negative_eigenvalues(); }

  /// The smallest tolerance for factors in single precision, and what fresh ones in double reach at once.
  static constexpr double coarse = 1e-6, exact = 1e-8;
  static constexpr double reduction = 1e3, floor = 1e-11;
  static constexpr int most_iterations = 30;

 private:
  DirectSolver direct_;
  Ranks ranks_;
  double tolerance_;
};

}  // namespace sbeh::surface3d
