// A chain of elements against the dense matrix that it sums to.
#include "model/numerics/chain_matrix.h"

#include <gtest/gtest.h>

namespace sbeh::model {
namespace {

constexpr int N = 3;
using Chain = ChainMatrix<N>;

// Symmetric and indefinite, its eigenvalues far from 0.
Chain random_chain(int elements) {
  std::srand(1);
  Chain chain(elements);
  for (int e = 0; e < elements; ++e) {
    const Chain::Element half = Chain::Element::Random();
    chain.element(e) = half + half.transpose();
    for (int i = 0; i < 4 * N; ++i) chain.element(e)(i, i) += i % N == 0 ? -30 : 30;
  }
  return chain;
}

Eigen::MatrixXd dense(const Chain& chain) {
  Eigen::MatrixXd all = Eigen::MatrixXd::Zero(chain.size(), chain.size());
  for (int e = 0; e < chain.elements(); ++e)
    all.block<4 * N, 4 * N>(3 * N * e, 3 * N * e) += chain.element(e);
  return all;
}

TEST(ChainMatrix, multiplies_and_solves_like_the_dense_one) {
  for (const int elements : {1, 2, 7}) {
    const Chain chain = random_chain(elements);
    const Eigen::MatrixXd all = dense(chain);
    const Eigen::VectorXd x = Eigen::VectorXd::Random(chain.size()), b = all * x;
    EXPECT_LT((chain.times(x) - b).norm(), 1e-13 * b.norm());
    const ChainInverse<N> inverse(chain);
    ASSERT_TRUE(inverse.usable());
    Eigen::VectorXd solved = b;
    inverse.solve(solved);
    EXPECT_LT((solved - x).norm(), 1e-13 * x.norm()) << elements;
  }
}

TEST(ChainMatrix, pins_unknowns_once_at_joints_and_within_elements) {
  constexpr int elements = 3;
  for (int i = 0; i < N * (3 * elements + 1); ++i) {
    Chain chain = random_chain(elements);
    Eigen::MatrixXd all = dense(chain);
    all.row(i).setZero();
    all.col(i).setZero();
    all(i, i) = 5;
    chain.pin(i, 5);
    EXPECT_EQ(dense(chain), all) << i;
  }
}

TEST(ChainMatrix, that_is_singular_is_not_usable) {
  Chain chain = random_chain(4);
  for (const int joint : {0, 2 * 3 * N, 4 * 3 * N}) {
    Chain singular = chain;
    singular.pin(joint, 0);
    EXPECT_FALSE(ChainInverse<N>(singular).usable()) << joint;
  }
  Chain within = chain;
  within.pin(N, 0);
  EXPECT_FALSE(ChainInverse<N>(within).usable());
  chain.element(2)(1, 1) = std::nan("");
  EXPECT_FALSE(ChainInverse<N>(chain).usable());
}

}  // namespace
}  // namespace sbeh::model
