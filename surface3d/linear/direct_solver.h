// Sparse direct factorisation by MUMPS.
#pragma once

#include "surface3d/linear/ranks.h"
#include "surface3d/linear/sparse_pattern.h"

#include <memory>
#include <string>

namespace sbeh::surface3d {

enum class Symmetry { general, symmetric };
/// Of the factors: double or float.
enum class Precision { full, single };

/// LU (or LDLᵀ) of a sparse matrix whose structure stays the same from one factorisation to the next. Where
/// several ranks share it each gives a part, whose sum is the matrix, and all have the same right-hand sides
/// and solutions.
class DirectSolver {
 public:
  explicit DirectSolver(Symmetry symmetry, Precision precision = Precision::full,
                        const Ranks& ranks = {});
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
  friend class SharedFactors;
  class Factors;
  template <class Number>
  class Mumps;
  static std::unique_ptr<Factors> factors(Symmetry symmetry, Precision precision,
                                          const Ranks& ranks, const Ranks& helpers);
  std::unique_ptr<Factors> factors_;
};

/// While it lives, what a process factors alone is factored by all ranks, each of which keeps a part of the
/// factors. For what the first one does while the others have nothing else to do but to serve.
class SharedFactors {
 public:
  /// By the first rank.
  explicit SharedFactors(const Ranks& ranks);
  ~SharedFactors();
  SharedFactors(const SharedFactors&) = delete;
  SharedFactors& operator=(const SharedFactors&) = delete;

  /// Whether what the first rank has sent is for this; the part of another rank in it.
  static bool is_meant(const std::string& message);
  static void serve(const std::string& message);
};

}  // namespace sbeh::surface3d
