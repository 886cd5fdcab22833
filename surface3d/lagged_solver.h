// Linear systems that change little from one to the next: old factors and a few iterations.
#pragma once

#include "surface3d/direct_solver.h"

namespace sbeh::surface3d {

/// Solves A x = b by GMRES with the factors of an earlier matrix as left preconditioner, so that the
/// residual measures the error of the solution.
class LaggedSolver {
 public:
  explicit LaggedSolver(Symmetry symmetry) : direct_(symmetry) {}

  [[nodiscard]] bool factor(const SparseMatrix& A) { return direct_.factor(A); }

  /// Improves the guess x, which may be 0, until the preconditioned residual is `tolerance` of x. Returns
  /// the number of times the factors were applied; 0 when that did not suffice, and then x is as it was.
  int solve(const SparseMatrix& A, const Eigen::VectorXd& b, Eigen::VectorXd& x) const;

  /// What a factorisation costs, in applications of its factors.
  double cost_of_factoring() const;

  static constexpr double tolerance = 1e-10;
  static constexpr int most_iterations = 30;

 private:
  DirectSolver direct_;
};

}  // namespace sbeh::surface3d
