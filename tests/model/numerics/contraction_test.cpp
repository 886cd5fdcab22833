// The contraction Tᵀ D B against dense matrices.
#include "model/numerics/contraction.h"

#include <Eigen/Core>
#include <gtest/gtest.h>

#include <array>
#include <limits>

namespace sbeh::model {
namespace {

constexpr int count = 4, unknowns = 12, data = 5;
// Sums of at most data² products of numbers of order 1.
constexpr double rounding = data * data * 10 * std::numeric_limits<double>::epsilon();

// Five data that read three fields of four unknowns each: two of them twice, one in a shifted place.
struct Element {
  Eigen::Matrix<double, count, data> shapes = Eigen::Matrix<double, count, data>::Random();
  std::array<DataRow<count>, data> rows{{{0, shapes.col(0).data()},
                                         {0, shapes.col(1).data()},
                                         {4, shapes.col(2).data()},
                                         {8, shapes.col(3).data()},
                                         {6, shapes.col(4).data()}}};
  // Three factors of tests in other places.
  std::array<DataRow<count>, 3> tests{rows[4], rows[0], rows[3]};
  // data x unknowns
  Eigen::MatrixXd dense() const {
    Eigen::MatrixXd B = Eigen::MatrixXd::Zero(data, unknowns);
    for (int i = 0; i < data; ++i)
      B.block(i, rows[std::size_t(i)].first, 1, count) = shapes.col(i).transpose();
    return B;
  }
};

TEST(Contraction, adds_the_weighted_matrix) {
  const Element element;
  Eigen::Matrix<double, 3, data> D = Eigen::Matrix<double, 3, data>::Random();
  D(1, 3) = D(2, 0) = 0;  // entries that are skipped
  const Eigen::Matrix<double, unknowns, unknowns> before =
      Eigen::Matrix<double, unknowns, unknowns>::Random();
  Eigen::Matrix<double, unknowns, unknowns> matrix = before;
  add_matrix(element.tests, element.rows, D, 0.7, matrix);
  const Eigen::MatrixXd B = element.dense(), T = B(std::array{4, 0, 3}, Eigen::all);
  EXPECT_LT((matrix - before - 0.7 * T.transpose() * D * B).cwiseAbs().maxCoeff(), rounding);
}

TEST(Contraction, has_tests_as_rows_and_unknowns_as_columns) {
  const Element element;
  Eigen::Matrix<double, data, data> D = Eigen::Matrix<double, data, data>::Zero();
  D(2, 3) = 1;  // datum 2 tests, datum 3 is the unknown
  Eigen::Matrix<double, unknowns, unknowns> matrix =
      Eigen::Matrix<double, unknowns, unknowns>::Zero();
  add_matrix(element.rows, element.rows, D, 1, matrix);
  EXPECT_GT((matrix.block<count, count>(4, 8).norm()), 0.1);
  matrix.block<count, count>(4, 8).setZero();
  EXPECT_EQ(matrix.norm(), 0);
}

TEST(Contraction, adds_the_weighted_vector) {
  const Element element;
  const Eigen::Matrix<double, data, 1> g = Eigen::Matrix<double, data, 1>::Random();
  const Eigen::Matrix<double, unknowns, 1> before = Eigen::Matrix<double, unknowns, 1>::Random();
  Eigen::Matrix<double, unknowns, 1> vector = before;
  add_vector(element.rows, g, -1.3, vector);
  EXPECT_LT((vector - before + 1.3 * element.dense().transpose() * g).cwiseAbs().maxCoeff(),
            rounding);
}

}  // namespace
}  // namespace sbeh::model
