// Sparse direct factorisation by MUMPS.
#pragma once

#include "surface3d/linear/sparse_pattern.h"

#include <memory>

namespace sbeh::surface3d {

enum class Symmetry { general, symmetric };
/// Of the factors: double or float.
enum class Precision { full, single };

/// LU (or LDLᵀ) of a sparse matrix whose structure stays the same from one factorisation to the next.
class DirectSolver {
 public:
  explicit DirectSolver(Symmetry symmetry, Precision precision = Precision::full);
  ~DirectSolver();
  DirectSolver(DirectSolver&&) noexcept;
  DirectSolver& operator=(DirectSolver&&) noexcept;

  /// Factors A; the first call analyses the structure, which later calls must keep. False when A is
  /// exactly singular or not finite; where it is singular to rounding, the solutions are large.
  [[nodiscard]] bool factor(const SparseMatrix& A);
  /// Overwrites the columns of rhs (n x k) with A⁻¹ rhs; after factor().
  void solve(Eigen::Ref<Eigen::MatrixXd> rhs) const;

  /// Of the last factorisation: floating-point operations, entries of the factors.
  double flops() const;
  double entries() const;
  /// Of a symmetric matrix, as the last factorisation had them: negative eigenvalues.
  int negative_eigenvalues() const;

 private:
  class Factors;
  template <class Number>
  class Mumps;
  std::unique_ptr<Factors> factors_;
};

}  // namespace sbeh::surface3d
