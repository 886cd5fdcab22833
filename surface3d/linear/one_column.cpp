// Two BLAS routines for MUMPS, as its solve phase calls them: with one column.
//
// OpenBLAS copies the matrix of a product before it multiplies, which pays for many columns and doubles
// the time for one. These take the place of its routines wherever the program calls `sgemm_` and
// `strsm_`, and hand on what has more columns. Nothing but the factors in single precision calls them.

#include <Eigen/Core>
#include <cblas.h>

namespace {

using Matrix = Eigen::Map<const Eigen::MatrixXf, 0, Eigen::OuterStride<>>;
using Column = Eigen::Map<Eigen::VectorXf>;
using ConstColumn = Eigen::Map<const Eigen::VectorXf>;

bool is(char option, char letter) { return (option & ~0x20) == letter; }  // in either case

template <unsigned Half>
void solve(const Matrix& A, bool transposed, Column x) {
  constexpr unsigned other = Half ^ (Eigen::Upper | Eigen::Lower);
  if (transposed)
    A.transpose().triangularView<other>().solveInPlace(x);
  else
    A.triangularView<Half>().solveInPlace(x);
}

CBLAS_TRANSPOSE transposition(char option) { return is(option, 'N') ? CblasNoTrans : CblasTrans; }

}  // namespace

// NOLINTBEGIN(readability-identifier-naming): the names of BLAS

// C = β C + α op(A) op(B); C: m x n, op(A): m x k.
extern "C" void sgemm_(const char* op_A, const char* op_B, const int* m, const int* n, const int* k,
                       const float* alpha, const float* A, const int* lda, const float* B,
                       const int* ldb, const float* beta, float* C, const int* ldc) {
  if (*n != 1 || !is(*op_B, 'N'))
    return cblas_sgemm(CblasColMajor, transposition(*op_A), transposition(*op_B), *m, *n, *k,
                       *alpha, A, *lda, B, *ldb, *beta, C, *ldc);
  Column y(C, *m);
  const ConstColumn x(B, *k);
  if (*beta == 0)
    y.setZero();
  else if (*beta != 1)
    y *= *beta;
  if (is(*op_A, 'N'))
    y.noalias() += *alpha * (Matrix(A, *m, *k, Eigen::OuterStride<>(*lda)) * x);
  else
    y.noalias() += *alpha * (Matrix(A, *k, *m, Eigen::OuterStride<>(*lda)).transpose() * x);
}

// B = α op(A)⁻¹ B, A triangular, m x m; or from the right.
extern "C" void strsm_(const char* side, const char* half, const char* op_A, const char* diagonal,
                       const int* m, const int* n, const float* alpha, const float* A,
                       const int* lda, float* B, const int* ldb) {
  const bool upper = is(*half, 'U'), unit = is(*diagonal, 'U'), left = is(*side, 'L');
  if (*n != 1 || !left)
    return cblas_strsm(CblasColMajor, left ? CblasLeft : CblasRight,
                       upper ? CblasUpper : CblasLower, transposition(*op_A),
                       unit ? CblasUnit : CblasNonUnit, *m, *n, *alpha, A, *lda, B, *ldb);
  const Matrix triangle(A, *m, *m, Eigen::OuterStride<>(*lda));
  Column x(B, *m);
  if (*alpha != 1) x *= *alpha;
  const bool transposed = !is(*op_A, 'N');
  if (upper && unit)
    solve<Eigen::UnitUpper>(triangle, transposed, x);
  else if (upper)
    solve<Eigen::Upper>(triangle, transposed, x);
  else if (unit)
    solve<Eigen::UnitLower>(triangle, transposed, x);
  else
    solve<Eigen::Lower>(triangle, transposed, x);
}

// NOLINTEND(readability-identifier-naming)
