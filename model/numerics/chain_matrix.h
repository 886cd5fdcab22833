// A symmetric matrix that is a sum over a chain of cubic elements, and its inverse by condensation of what is within
// the elements: O(elements).
#pragma once

#include <Eigen/LU>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace sbeh::model {

/// Element e has the nodes 3e … 3e + 3, each with N unknowns, node by node.
template <int N>
class ChainMatrix {
 public:
  static constexpr int node_size = N;
  using Element = Eigen::Matrix<double, 4 * N, 4 * N>;

  explicit ChainMatrix(int elements) : elements_(std::size_t(elements), Element::Zero()) {}

  int elements() const { return int(elements_.size()); }
  int size() const { return N * (3 * elements() + 1); }
  Element& element(int e) { return elements_[std::size_t(e)]; }
  const Element& element(int e) const { return elements_[std::size_t(e)]; }

  /// += factor · other, of the same size.
  void add(double factor, const ChainMatrix& other) {
    for (int e = 0; e < elements(); ++e) element(e) += factor * other.element(e);
  }
  /// Row and column i become zero, and `diagonal` where they meet.
  void pin(int i, double diagonal) {
    const int last = elements() - 1, node = i / N;
    for (int e = std::max(0, (node - 1) / 3); e <= std::min(last, node / 3); ++e) {
      const int k = i - 3 * N * e;
      element(e).row(k).setZero();
      element(e).col(k).setZero();
      element(e)(k, k) = diagonal;
      diagonal = 0;  // once for both elements of a joint
    }
  }
  Eigen::VectorXd times(const Eigen::VectorXd& x) const {
    Eigen::VectorXd y = Eigen::VectorXd::Zero(size());
    for (int e = 0; e < elements(); ++e)
      y.segment<4 * N>(3 * N * e).noalias() += element(e) * x.segment<4 * N>(3 * N * e);
    return y;
  }

 private:
  std::vector<Element> elements_;
};

/// Pivots are sought within a node at a joint and within what lies between two joints.
template <int N>
class ChainInverse {
 public:
  explicit ChainInverse(const ChainMatrix<N>& matrix)
      : within_(std::size_t(matrix.elements())), joints_(within_.size() + 1) {
    std::vector<Block> diagonal(joints_.size(), Block::Zero());
    for (std::size_t e = 0; e < within_.size(); ++e) {
      const auto& K = matrix.element(int(e));
      const Inner inner = K.template block<2 * N, 2 * N>(N, N);
      Border border;  // of what lies within, by both joints
      border << K.template block<2 * N, N>(N, 0), K.template block<2 * N, N>(N, 3 * N);
      within_[e].factors.compute(inner);
      within_[e].follows = within_[e].factors.solve(border);
      const Inner taken = border.transpose() * within_[e].follows;
      diagonal[e] += K.template block<N, N>(0, 0) - taken.template topLeftCorner<N, N>();
      diagonal[e + 1] +=
          K.template block<N, N>(3 * N, 3 * N) - taken.template bottomRightCorner<N, N>();
      joints_[e].follows = K.template block<N, N>(0, 3 * N) - taken.template topRightCorner<N, N>();
    }
    for (std::size_t j = 0; j < joints_.size(); ++j) {
      Joint& joint = joints_[j];
      joint.factors.compute(diagonal[j]);
      usable_ = usable_ && is_regular(joint.factors.matrixLU());
      if (j == within_.size()) break;
      const Block coupling = joint.follows;
      joint.follows = joint.factors.solve(coupling);
      diagonal[j + 1].noalias() -= coupling.transpose() * joint.follows;
    }
  }

  /// Whether the matrix is finite and not singular, as are the blocks of its pivots.
  bool usable() const { return usable_; }

  /// Overwrites x by the inverse times x.
  void solve(Eigen::Ref<Eigen::VectorXd> x) const {
    for (std::size_t e = 0; e < within_.size(); ++e) {
      const Eigen::Matrix<double, 2 * N, 1> taken = within_[e].follows.transpose() * inner(x, e);
      joint(x, e) -= taken.template head<N>();
      joint(x, e + 1) -= taken.template tail<N>();
      joint(x, e + 1).noalias() -= joints_[e].follows.transpose() * joint(x, e);
    }
    for (std::size_t j = joints_.size(); j-- > 0;) {
      joint(x, j) = joints_[j].factors.solve(joint(x, j)).eval();
      if (j == within_.size()) continue;
      joint(x, j).noalias() -= joints_[j].follows * joint(x, j + 1);
      Eigen::Matrix<double, 2 * N, 1> both;
      both << joint(x, j), joint(x, j + 1);
      inner(x, j) = (within_[j].factors.solve(inner(x, j)) - within_[j].follows * both).eval();
    }
  }

 private:
  using Block = Eigen::Matrix<double, N, N>;
  using Inner = Eigen::Matrix<double, 2 * N, 2 * N>;
  using Border = Inner;
  // A pivot's block, and its inverse times what couples it to what comes after.
  struct Within {
    Eigen::PartialPivLU<Inner> factors;
    Border follows;
  };
  struct Joint {
    Eigen::PartialPivLU<Block> factors;
    Block follows;
  };

  // What is singular within elements spreads to the joints as infinities.
  static bool is_regular(const Block& triangles) {
    return triangles.allFinite() && (triangles.diagonal().array() != 0).all();
  }
  static auto joint(Eigen::Ref<Eigen::VectorXd>& x, std::size_t j) {
    return x.segment<N>(3 * N * Eigen::Index(j));
  }
  static auto inner(Eigen::Ref<Eigen::VectorXd>& x, std::size_t e) {
    return x.segment<2 * N>(3 * N * Eigen::Index(e) + N);
  }

  std::vector<Within> within_;
  std::vector<Joint> joints_;
  bool usable_ = true;
};

}  // namespace sbeh::model
