// The band matrix and its bordered system against dense linear algebra.
#include "tests/model/densely.h"

#include <Eigen/LU>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace sbeh::model {
namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();

class Random {
 public:
  Eigen::MatrixXd matrix(Eigen::Index rows, Eigen::Index columns) {
    return Eigen::MatrixXd::NullaryExpr(rows, columns, [this] { return uniform_(engine_); });
  }
  // A matrix in both storages.
  struct Pair {
    BandMatrix band;
    Eigen::MatrixXd dense;
  };
  Pair band_matrix(int n, int half_width) {
    Pair pair{BandMatrix(n, half_width), matrix(n, n)};
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j) {
        if (std::abs(i - j) > half_width) pair.dense(i, j) = 0;
        if (std::abs(i - j) <= half_width) pair.band(i, j) = pair.dense(i, j);
      }
    return pair;
  }

 private:
  std::mt19937 engine_{7};
  std::uniform_real_distribution<double> uniform_{-1, 1};
};

int sign(double x) { return x < 0 ? -1 : 1; }

// Two backward stable solutions differ by at most about cond(A) n ε |x|.
double tolerance(const Eigen::MatrixXd& A, const Eigen::MatrixXd& x) {
  return 10 * double(A.rows()) * epsilon / A.partialPivLu().rcond() * x.norm();
}

struct Shape {
  int n, half_width;
};
const std::vector<Shape> shapes{{1, 0}, {5, 0}, {6, 1}, {17, 3}, {40, 5}, {4, 6}, {60, 22}};

TEST(BandMatrix, has_the_entries_of_a_dense_one) {
  Random random;
  for (const auto [n, half_width] : shapes) {
    const auto [band, dense] = random.band_matrix(n, half_width);
    EXPECT_EQ(band.size(), n);
    EXPECT_EQ(band.half_width(), half_width);
    EXPECT_EQ(densely(band), dense);
  }
}

TEST(BandMatrix, solves_like_a_dense_one_for_several_right_hand_sides) {
  Random random;
  for (const auto [n, half_width] : shapes)
    for (int repeat = 0; repeat < 5; ++repeat) {
      auto [band, dense] = random.band_matrix(n, half_width);
      Eigen::MatrixXd x = random.matrix(n, 3);
      const Eigen::MatrixXd expected = dense.partialPivLu().solve(x);
      ASSERT_TRUE(band.factor());
      band.solve(x);
      EXPECT_LT((x - expected).norm(), tolerance(dense, expected)) << n << " " << half_width;
    }
}

TEST(BandMatrix, solves_some_columns_of_a_larger_matrix_in_place) {
  Random random;
  auto [band, dense] = random.band_matrix(9, 2);
  Eigen::MatrixXd all = random.matrix(12, 4);
  const Eigen::MatrixXd before = all;
  const Eigen::MatrixXd expected = dense.partialPivLu().solve(all.block(2, 1, 9, 2));
  ASSERT_TRUE(band.factor());
  band.solve(all.block(2, 1, 9, 2));
  EXPECT_LT((all.block(2, 1, 9, 2) - expected).norm(), tolerance(dense, expected));
  all.block(2, 1, 9, 2) = before.block(2, 1, 9, 2);
  EXPECT_EQ(all, before) << "the rest is untouched";
}

TEST(BandMatrix, knows_the_sign_of_its_determinant) {
  Random random;
  int negative = 0;
  for (const auto [n, half_width] : shapes)
    for (int repeat = 0; repeat < 10; ++repeat) {
      auto [band, dense] = random.band_matrix(n, half_width);
      ASSERT_TRUE(band.factor());
      EXPECT_EQ(band.determinant_sign(), sign(dense.partialPivLu().determinant()));
      negative += band.determinant_sign() < 0;
    }
  EXPECT_GT(negative, 10) << "both signs occur";
}

TEST(BandMatrix, may_have_rows_of_the_identity) {
  Random random;
  auto [band, dense] = random.band_matrix(8, 2);
  for (const int row : {0, 3, 7}) {
    band.set_identity_row(row);
    dense.row(row) = Eigen::RowVectorXd::Unit(8, row);
  }
  EXPECT_EQ(densely(band), dense);
}

TEST(BandMatrix, can_be_used_again_after_a_factorisation) {
  Random random;
  auto [band, dense] = random.band_matrix(10, 3);
  ASSERT_TRUE(band.factor());
  band.set_zero();
  for (int i = 0; i < 10; ++i) band(i, i) = 2;
  ASSERT_TRUE(band.factor());
  Eigen::MatrixXd x = Eigen::VectorXd::LinSpaced(10, 1, 10);
  band.solve(x);
  EXPECT_EQ(x, Eigen::VectorXd::LinSpaced(10, 0.5, 5));
}

TEST(BandMatrix, that_is_singular_is_not_factored) {
  Random random;
  auto [band, dense] = random.band_matrix(10, 2);
  for (int i = 2; i <= 6; ++i) band(i, 4) = 0;  // a column of zeros
  EXPECT_FALSE(band.factor());
  EXPECT_FALSE(BandMatrix(3, 1).factor());
}

TEST(BandMatrix, that_is_not_finite_is_not_factored) {
  for (const double bad :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()})
    for (const int place : {0, 5, 9}) {
      Random random;
      auto [band, dense] = random.band_matrix(10, 2);
      band(place, place) = bad;
      EXPECT_FALSE(band.factor()) << bad << " at " << place;
    }
}

// [A  B; Cᵀ D] (x; y) = (f; g) in both storages.
struct Bordered {
  Bordered(Random& random, int n, int half_width, int m)
      : pair(random.band_matrix(n, half_width)),
        B(random.matrix(n, m)),
        C(random.matrix(n, m)),
        D(random.matrix(m, m)),
        f(random.matrix(n, 1)),
        g(random.matrix(m, 1)) {}
  Eigen::MatrixXd matrix() const {
    Eigen::MatrixXd M(f.size() + g.size(), f.size() + g.size());
    M << pair.dense, B, C.transpose(), D;
    return M;
  }
  Eigen::VectorXd rhs() const {
    Eigen::VectorXd r(f.size() + g.size());
    r << f, g;
    return r;
  }
  Random::Pair pair;
  Eigen::MatrixXd B, C, D;
  Eigen::VectorXd f, g;
};

TEST(BorderedSystem, is_solved_like_a_dense_one_with_the_sign_of_its_determinant) {
  Random random;
  int negative = 0;
  for (const auto [n, half_width] : shapes)
    for (int m = 1; m <= 3; ++m) {
      Bordered system(random, n, half_width, m);
      const Eigen::MatrixXd dense = system.matrix();
      const Eigen::VectorXd expected = dense.partialPivLu().solve(system.rhs());
      ASSERT_TRUE(system.pair.band.factor());
      const BorderedSolution s =
          solve_bordered(system.pair.band, system.B, system.C, system.D, system.f, system.g);
      ASSERT_EQ(s.x.size(), n);
      ASSERT_EQ(s.y.size(), m);
      Eigen::VectorXd found(n + m);
      found << s.x, s.y;
      // Elimination of A first is as stable as A is well conditioned.
      const double condition = 1 / system.pair.dense.partialPivLu().rcond();
      EXPECT_LT((found - expected).norm(), condition * tolerance(dense, expected)) << n << " " << m;
      EXPECT_EQ(s.determinant_sign, sign(dense.partialPivLu().determinant()));
      negative += s.determinant_sign < 0;
    }
  EXPECT_GT(negative, 5) << "both signs occur";
}

TEST(BorderedSystem, without_a_border_is_the_band_matrix) {
  Random random;
  Bordered system(random, 9, 2, 0);
  ASSERT_TRUE(system.pair.band.factor());
  Eigen::MatrixXd expected = system.f;
  system.pair.band.solve(expected);
  const BorderedSolution s =
      solve_bordered(system.pair.band, system.B, system.C, system.D, system.f, system.g);
  EXPECT_EQ(s.x, expected.col(0));
  EXPECT_EQ(s.y.size(), 0);
  EXPECT_EQ(s.determinant_sign, system.pair.band.determinant_sign());
}

TEST(BorderedSystem, that_is_singular_has_no_solution) {
  Random random;
  Bordered system(random, 8, 2, 2);
  system.C.col(1).setZero();
  system.D.row(1).setZero();
  ASSERT_TRUE(system.pair.band.factor());
  const BorderedSolution s =
      solve_bordered(system.pair.band, system.B, system.C, system.D, system.f, system.g);
  EXPECT_EQ(s.x.size(), 0);
}

}  // namespace
}  // namespace sbeh::model
