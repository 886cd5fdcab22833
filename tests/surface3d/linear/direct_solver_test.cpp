// The sparse factorisation against a dense one, and what it refuses.
#include "surface3d/linear/direct_solver.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <gtest/gtest.h>

#include <limits>
#include <random>

namespace sbeh::surface3d {
namespace {

constexpr int n = 60;
constexpr double epsilon = std::numeric_limits<double>::epsilon();

// A random sparse matrix with a zero block like a pressure's in the last third of the diagonal.
SparseMatrix saddle_point(bool symmetric, unsigned seed) {
  std::mt19937 random(seed);
  const auto number = [&] { return double(random() % 2001) / 1000 - 1; };
  Eigen::MatrixXd A = Eigen::MatrixXd::Zero(n, n);
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j)
      if ((i < 40 || j < 40) && random() % 5 == 0) A(i, j) = number();
  A.diagonal().head(40).array() += 4;
  for (int k = 40; k < n; ++k) A(k, k - 30) = A(k - 30, k) = 2;
  if (symmetric) A = ((A + A.transpose()) / 2).eval();
  return A.sparseView();
}

// Relative to |x|, of a solution with condition number κ.
double allowed(const Eigen::MatrixXd& A) { return 10 * n * epsilon / A.partialPivLu().rcond(); }

TEST(DirectSolver, solves_like_a_dense_factorisation) {
  for (const Symmetry symmetry : {Symmetry::general, Symmetry::symmetric}) {
    const SparseMatrix A = saddle_point(symmetry == Symmetry::symmetric, 1);
    const Eigen::MatrixXd dense(A), rhs = Eigen::MatrixXd::Random(n, 3);
    DirectSolver solver(symmetry);
    ASSERT_TRUE(solver.factor(A));
    Eigen::MatrixXd x = rhs;
    solver.solve(x);
    const Eigen::MatrixXd exact = dense.partialPivLu().solve(rhs);
    EXPECT_LT((x - exact).norm(), allowed(dense) * exact.norm());
    EXPECT_GT(solver.flops(), n);
  }
}

TEST(DirectSolver, counts_negative_eigenvalues) {
  for (const unsigned seed : {1u, 2u, 3u}) {
    const SparseMatrix A = saddle_point(true, seed);
    DirectSolver solver(Symmetry::symmetric);
    ASSERT_TRUE(solver.factor(A));
    const Eigen::VectorXd eigenvalues =
        Eigen::MatrixXd(A).selfadjointView<Eigen::Lower>().eigenvalues();
    EXPECT_EQ(solver.negative_eigenvalues(), (eigenvalues.array() < 0).count());
    EXPECT_GT(solver.negative_eigenvalues(), 0);
  }
}

TEST(DirectSolver, has_factors_in_single_precision_too) {
  const SparseMatrix A = saddle_point(false, 1);
  const Eigen::MatrixXd dense(A), rhs = Eigen::MatrixXd::Random(n, 2);
  DirectSolver single(Symmetry::general, Precision::single);
  ASSERT_TRUE(single.factor(A));
  Eigen::MatrixXd x = rhs;
  single.solve(x);
  const Eigen::MatrixXd exact = dense.partialPivLu().solve(rhs);
  const double coarser = std::numeric_limits<float>::epsilon() / epsilon;
  EXPECT_LT((x - exact).norm(), coarser * allowed(dense) * exact.norm());
  EXPECT_GT((x - exact).norm(), epsilon * exact.norm());
}

TEST(DirectSolver, takes_new_values_in_the_same_structure) {
  const SparseMatrix A = saddle_point(false, 2);
  SparseMatrix B = A;
  B.coeffs() = B.coeffs() * 3 + 0.1;
  DirectSolver solver(Symmetry::general);
  ASSERT_TRUE(solver.factor(A));
  ASSERT_TRUE(solver.factor(B));
  const Eigen::VectorXd exact = Eigen::VectorXd::LinSpaced(n, -1, 2);
  Eigen::MatrixXd x = B * exact;
  solver.solve(x);
  EXPECT_LT((x - exact).norm(), allowed(Eigen::MatrixXd(B)) * exact.norm());
}

TEST(DirectSolver, reads_one_triangle_of_a_symmetric_matrix) {
  SparseMatrix A = saddle_point(true, 3);
  const Eigen::MatrixXd dense(A);
  for (int i = 0; i < n; ++i)  // above the diagonal: nonsense
    for (SparseMatrix::InnerIterator entry(A, i); entry; ++entry)
      if (entry.col() > i) entry.valueRef() = 17;
  DirectSolver solver(Symmetry::symmetric);
  ASSERT_TRUE(solver.factor(A));
  const Eigen::VectorXd exact = Eigen::VectorXd::LinSpaced(n, 1, 2);
  Eigen::MatrixXd x = dense * exact;
  solver.solve(x);
  EXPECT_LT((x - exact).norm(), allowed(dense) * exact.norm());
}

TEST(DirectSolver, refuses_an_exactly_singular_matrix_and_goes_on_afterwards) {
  for (const Symmetry symmetry : {Symmetry::general, Symmetry::symmetric}) {
    const SparseMatrix A = saddle_point(symmetry == Symmetry::symmetric, 4);
    SparseMatrix singular = saddle_point(symmetry == Symmetry::symmetric, 4);
    for (int i = 0; i < n; ++i)
      for (SparseMatrix::InnerIterator entry(singular, i); entry; ++entry)
        if (i == 7 || entry.col() == 7) entry.valueRef() = 0;
    DirectSolver solver(symmetry);
    EXPECT_FALSE(solver.factor(singular));
    ASSERT_TRUE(solver.factor(A));
    const Eigen::VectorXd exact = Eigen::VectorXd::Ones(n);
    Eigen::MatrixXd x = A * exact;
    solver.solve(x);
    EXPECT_LT((x - exact).norm(), allowed(Eigen::MatrixXd(A)) * exact.norm());
  }
}

TEST(DirectSolver, refuses_numbers_that_are_not_finite) {
  for (const double bad :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()})
    for (const Symmetry symmetry : {Symmetry::general, Symmetry::symmetric}) {
      const SparseMatrix A = saddle_point(symmetry == Symmetry::symmetric, 5);
      SparseMatrix broken = A;
      broken.coeffRef(40, 10) = bad;
      DirectSolver solver(symmetry);
      EXPECT_FALSE(solver.factor(broken));
      EXPECT_TRUE(solver.factor(A));
      EXPECT_FALSE(solver.factor(broken));
    }
}

}  // namespace
}  // namespace sbeh::surface3d
