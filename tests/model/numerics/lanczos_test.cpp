// Lanczos' iteration against dense eigenvalues.
#include "model/numerics/lanczos.h"

#include "model/numerics/block_lanczos.h"

#include <Eigen/Cholesky>
#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace sbeh::model {
namespace {

// A symmetric matrix and a mass; A x = θ⁻¹ M x has the eigenvalues θ of x → A⁻¹ M x.
struct Pencil {
  Eigen::MatrixXd A, M;
  explicit Pencil(int n) : A(n, n), M(Eigen::MatrixXd::Zero(n, n)) {
    for (int i = 0; i < n; ++i) {
      for (int j = 0; j < n; ++j) A(i, j) = 1. / (1 + i + j);
      A(i, i) += i + 0.5;
      M(i, i) = 1 + 0.1 * i;
    }
  }
};

TEST(Lanczos, finds_the_largest_of_both_signs) {
  for (const double shift : {0., 3.2, 7.7}) {
    Pencil p(30);
    p.A -= shift * p.M;
    const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> exact(p.A, p.M);
    Eigen::VectorXd theta = exact.eigenvalues().cwiseInverse();
    std::ranges::sort(theta, std::greater{}, [](double t) { return std::abs(t); });
    const Eigen::PartialPivLU<Eigen::MatrixXd> lu(p.A);
    const auto apply = [&](const Eigen::VectorXd& x) { return Eigen::VectorXd(lu.solve(x)); };
    const auto mass = [&](const Eigen::VectorXd& x) { return Eigen::VectorXd(p.M * x); };
    const auto found =
        largest_by_lanczos(apply, mass, Eigen::VectorXd::LinSpaced(30, 1, 2), 3, 30, 1e-13);
    ASSERT_TRUE(found);
    for (int k = 0; k < 3; ++k) {
      EXPECT_NEAR(found->values[k] / theta[k], 1, 1e-11) << shift;
      const Eigen::VectorXd x = found->vectors.col(k);
      EXPECT_NEAR(x.dot(p.M * x), 1, 1e-11);
      EXPECT_LT((apply(p.M * x) - theta[k] * x).norm(), 1e-6);
    }
    EXPECT_EQ(found->least < 0, theta.minCoeff() < 0);
    EXPECT_GE(found->least, theta.minCoeff() - 1e-11);
  }
}

TEST(Lanczos, finds_fewer_where_the_start_spans_no_more) {
  const auto same = [](const Eigen::VectorXd& x) { return x; };
  const auto twice = [](const Eigen::VectorXd& x) { return Eigen::VectorXd(2 * x); };
  const auto found = largest_by_lanczos(twice, same, Eigen::VectorXd::Ones(5), 3, 20);
  ASSERT_TRUE(found);
  ASSERT_EQ(found->values.size(), 1);
  EXPECT_NEAR(found->values[0], 2, 1e-14);
}

TEST(Lanczos, says_when_the_steps_do_not_suffice_or_a_value_is_not_finite) {
  const Pencil p(30);
  const auto apply = [&](const Eigen::VectorXd& x) { return Eigen::VectorXd(p.A * x); };
  const auto same = [](const Eigen::VectorXd& x) { return x; };
  EXPECT_FALSE(largest_by_lanczos(apply, same, Eigen::VectorXd::Ones(30), 5, 8, 1e-14));
  const auto broken = [](const Eigen::VectorXd& x) { return Eigen::VectorXd(x / 0.); };
  EXPECT_FALSE(largest_by_lanczos(broken, same, Eigen::VectorXd::Ones(30), 1, 20));
}

// A diagonal problem in which 2, −3 and 0.5 have three vectors each.
TEST(BlockLanczos, finds_all_vectors_of_an_eigenvalue) {
  constexpr int n = 60;
  Eigen::VectorXd theta(n), masses(n);
  for (int i = 0; i < n; ++i) {
    theta[i] = i < 9 ? std::array{2., -3., 0.5}[std::size_t(i % 3)] : 0.4 / (i - 8);
    masses[i] = 1 + 0.3 * (i % 7);
  }
  const auto mass = [&](const Eigen::MatrixXd& x) {
    return Eigen::MatrixXd(masses.asDiagonal() * x);
  };
  const auto apply = [&](const Eigen::MatrixXd& x) {
    return Eigen::MatrixXd(theta.cwiseQuotient(masses).asDiagonal() * x);
  };
  Eigen::MatrixXd start(n, 3);
  for (int i = 0; i < n; ++i) start.row(i) << 1, std::cos(i), std::sin(2 * i);
  const auto found = largest_by_block_lanczos(apply, mass, start, 8, n, 1e-12);
  ASSERT_TRUE(found);
  const double expected[] = {-3, -3, -3, 2, 2, 2, 0.5, 0.5};
  for (int k = 0; k < 8; ++k) {
    EXPECT_NEAR(found->values[k], expected[k], 1e-11);
    const Eigen::VectorXd x = found->vectors.col(k);
    EXPECT_NEAR(x.dot(mass(x).col(0)), 1, 1e-11);
    EXPECT_LT((apply(mass(x)) - found->values[k] * x).norm(), 1e-5);
  }
  EXPECT_NEAR(found->least, -3, 1e-11);
  EXPECT_FALSE(largest_by_block_lanczos(apply, mass, start, 8, 6, 1e-12));
}

}  // namespace
}  // namespace sbeh::model
