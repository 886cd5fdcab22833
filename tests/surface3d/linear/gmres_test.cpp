// GMRES with old factors.
#include "surface3d/linear/gmres.h"

#include <Eigen/LU>
#include <gtest/gtest.h>

#include <random>

namespace sbeh::surface3d {
namespace {

constexpr int n = 60;

Eigen::MatrixXd random_matrix(unsigned seed) {
  std::mt19937 random(seed);
  return Eigen::MatrixXd::NullaryExpr(
      n, n, [&](Eigen::Index, Eigen::Index) { return double(random() % 2001) / 1000 - 1; });
}

SparseMatrix well_conditioned() {
  const Eigen::MatrixXd A = random_matrix(1) / n + 3 * Eigen::MatrixXd::Identity(n, n);
  return A.sparseView();
}

TEST(Gmres, meets_its_tolerance_in_either_precision) {
  const SparseMatrix old = well_conditioned();
  const SparseMatrix A = (Eigen::MatrixXd(old) + 0.3 * random_matrix(2) / n).sparseView();
  const Eigen::VectorXd exact = Eigen::VectorXd::LinSpaced(n, -1, 2);
  for (const double tolerance : {1e-3, 1e-5, 1e-8, 1e-10}) {
    Gmres solver(Symmetry::general, tolerance);
    ASSERT_TRUE(solver.factor(old));
    Eigen::VectorXd x = Eigen::VectorXd::Zero(n);
    EXPECT_GT(solver.solve(A, A * exact, x), 1);
    // The residual, multiplied by the inverse of a matrix that is 10 % off at most, is the error.
    EXPECT_LT((x - exact).norm(), 1.2 * tolerance * exact.norm()) << tolerance;
  }
}

TEST(Gmres, asks_for_less_than_its_tolerance_where_the_guess_is_better) {
  const SparseMatrix A = well_conditioned();
  const Eigen::VectorXd exact = Eigen::VectorXd::LinSpaced(n, -1, 2);
  Gmres solver(Symmetry::general, 1e-5);
  ASSERT_TRUE(solver.factor(A));
  Eigen::VectorXd x = exact + 1e-7 * Eigen::VectorXd::Ones(n);
  const double before = (x - exact).norm();
  ASSERT_GT(solver.solve(A, A * exact, x), 0);
  EXPECT_LT((x - exact).norm(), 1e-2 * before);
}

TEST(Gmres, needs_fewer_iterations_for_a_matrix_that_is_nearer) {
  const SparseMatrix old = well_conditioned();
  Gmres solver(Symmetry::general, 1e-8);
  ASSERT_TRUE(solver.factor(old));
  int before = 1;
  for (const double change : {0., 0.01, 0.5}) {
    const SparseMatrix A = (Eigen::MatrixXd(old) + change * random_matrix(3) / n).sparseView();
    Eigen::VectorXd x = Eigen::VectorXd::Zero(n);
    const int iterations = solver.solve(A, Eigen::VectorXd::Ones(n), x);
    EXPECT_GT(iterations, before) << change;
    before = iterations;
  }
}

TEST(Gmres, leaves_the_guess_alone_when_the_factors_are_too_old) {
  Gmres solver(Symmetry::general, 1e-8);
  ASSERT_TRUE(solver.factor(well_conditioned()));
  Eigen::VectorXd x = Eigen::VectorXd::Ones(n);
  EXPECT_EQ(solver.solve(random_matrix(4).sparseView(), Eigen::VectorXd::Unit(n, 0), x), 0);
  EXPECT_EQ(x, Eigen::VectorXd::Ones(n));
}

}  // namespace
}  // namespace sbeh::surface3d
