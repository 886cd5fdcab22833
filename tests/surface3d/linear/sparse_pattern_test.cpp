// The sparse matrix that a pattern fills is the sum of the element matrices.
#include "surface3d/linear/sparse_pattern.h"

#include <gtest/gtest.h>

#include <random>

namespace sbeh::surface3d {
namespace {

constexpr int size = 23, locals = 6, elements = 17;

struct Example {
  Eigen::MatrixXi unknowns = Eigen::MatrixXi(locals, elements);
  SparsePattern::Mask mask = SparsePattern::Mask(locals, locals);
  std::vector<Eigen::MatrixXd> matrices;
  std::vector<Eigen::VectorXd> vectors;
  explicit Example(unsigned seed) {
    std::mt19937 random(seed);
    const auto below = [&](int n) { return int(random() % unsigned(n)); };
    for (int e = 0; e < elements; ++e) {
      for (int i = 0; i < locals; ++i) unknowns(i, e) = below(size);  // some twice in one element
      matrices.emplace_back(Eigen::MatrixXd::Zero(locals, locals));
      vectors.emplace_back(Eigen::VectorXd::Zero(locals));
      for (double& x : matrices.back().reshaped()) x = below(1000);  // integers: sums are exact
      for (double& x : vectors.back()) x = below(1000);
    }
    for (bool& couples : mask.reshaped()) couples = below(3) > 0;
  }
};

TEST(SparsePattern, sums_element_matrices_like_a_dense_matrix) {
  for (const unsigned seed : {1u, 2u, 3u}) {
    const Example x(seed);
    const SparsePattern pattern(size, x.unknowns, x.mask);
    SparseMatrix A = pattern.zero();
    Eigen::VectorXd b = Eigen::VectorXd::Zero(size);
    Eigen::MatrixXd dense = Eigen::MatrixXd::Zero(size, size);
    Eigen::VectorXd dense_b = b;
    for (int e = 0; e < elements; ++e) {
      pattern.add(e, x.matrices[std::size_t(e)], A);
      pattern.add(e, x.vectors[std::size_t(e)], b);
      for (int i = 0; i < locals; ++i) {
        dense_b[x.unknowns(i, e)] += x.vectors[std::size_t(e)][i];
        for (int j = 0; j < locals; ++j)
          if (x.mask(i, j))
            dense(x.unknowns(i, e), x.unknowns(j, e)) += x.matrices[std::size_t(e)](i, j);
      }
    }
    EXPECT_EQ(Eigen::MatrixXd(A), dense);
    EXPECT_EQ(b, dense_b);
  }
}

TEST(SparsePattern, has_the_entries_of_common_unknowns_but_adds_none) {
  constexpr int common = 2;
  Example x(5);
  for (int e = 0; e < elements; ++e)
    x.unknowns.bottomRows<common>().col(e) = Eigen::Vector2i(size, size + 1);
  x.mask.bottomRightCorner<common, common>().setConstant(true);
  const SparsePattern whole(size + common, x.unknowns, x.mask),
      pattern(size + common, x.unknowns, x.mask, common);
  SparseMatrix A = pattern.zero(), all = whole.zero();
  Eigen::VectorXd b = Eigen::VectorXd::Zero(size + common), whole_b = b;
  EXPECT_EQ(A.nonZeros(), all.nonZeros());
  for (int e = 0; e < elements; ++e) {
    pattern.add(e, x.matrices[std::size_t(e)], A);
    pattern.add(e, x.vectors[std::size_t(e)], b);
    whole.add(e, x.matrices[std::size_t(e)], all);
    whole.add(e, x.vectors[std::size_t(e)], whole_b);
  }
  Eigen::MatrixXd expected(all);
  auto among_themselves = expected.bottomRightCorner<common, common>();
  EXPECT_GT(among_themselves.minCoeff(), 0);
  among_themselves.setZero();
  whole_b.tail<common>().setZero();
  EXPECT_EQ(Eigen::MatrixXd(A), expected);
  EXPECT_EQ(b, whole_b);
}

TEST(SparsePattern, has_each_entry_once_and_columns_in_order) {
  const Example x(4);
  const SparseMatrix A = SparsePattern(size, x.unknowns, x.mask).zero();
  EXPECT_TRUE(A.isCompressed());
  for (int row = 0; row < size; ++row) {
    int before = -1;
    for (SparseMatrix::InnerIterator entry(A, row); entry; ++entry) {
      EXPECT_GT(entry.col(), before);
      before = int(entry.col());
    }
  }
}

}  // namespace
}  // namespace sbeh::surface3d
