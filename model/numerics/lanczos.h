// The largest eigenvalues of a symmetric operator: Lanczos' iteration in the inner product of a mass matrix.
#pragma once

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

namespace sbeh::model {

struct RitzPairs {
  Eigen::VectorXd values;   ///< those of largest absolute value, largest first
  Eigen::MatrixXd vectors;  ///< in their columns, of length 1 in the mass
  double least;  ///< of all values that the space shows: where it is negative, so is an eigenvalue
};

/// A basis that is orthonormal in the mass, and the operator x → apply(mass x) on it, symmetric in (x, mass y).
template <class Apply, class Mass>
class KrylovSpace {
 public:
  KrylovSpace(const Apply& apply, const Mass& mass, Eigen::VectorXd start, int most)
      : apply_(apply), mass_(mass), next_(std::move(start)), projected_(most, most) {}

  int size() const { return int(basis_.size()); }
  /// Whether a vector could be added: otherwise the space is invariant.
  bool extend() {
    const Eigen::VectorXd with_mass = mass_(next_);
    const double length = std::sqrt(next_.dot(with_mass));
    if (size() > 0 && !(length > 1e-13 * std::abs(projected_(0, 0)))) return false;
    basis_.emplace_back(next_ / length);
    loaded_.emplace_back(with_mass / length);
    next_ = apply_(loaded_.back());
    const int k = size() - 1;
    projected_.col(k).setZero();
    for (int pass = 0; pass < 2; ++pass)  // twice is enough against rounding
      for (int j = 0; j <= k; ++j) {
        const double part = next_.dot(loaded_[std::size_t(j)]);
        next_ -= part * basis_[std::size_t(j)];
        projected_(j, k) += part;
      }
    return true;
  }
  /// The `count` largest values of the space.
  Eigen::VectorXd values(int count) const {
    const auto eigen = solved(Eigen::EigenvaluesOnly);
    return eigen.eigenvalues()(largest(eigen.eigenvalues(), count));
  }
  /// With their vectors.
  RitzPairs pairs(int count) const {
    const auto eigen = solved(Eigen::ComputeEigenvectors);
    const auto order = largest(eigen.eigenvalues(), count);
    RitzPairs pairs{eigen.eigenvalues()(order),
                    Eigen::MatrixXd::Zero(next_.size(), Eigen::Index(order.size())),
                    eigen.eigenvalues()[0]};
    const Eigen::MatrixXd coordinates = eigen.eigenvectors()(Eigen::all, order);
    for (int j = 0; j < size(); ++j) pairs.vectors += basis_[std::size_t(j)] * coordinates.row(j);
    return pairs;
  }

 private:
  // The operator on the basis is tridiagonal, but for rounding.
  Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solved(int options) const {
    const int n = size();
    Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen;
    eigen.computeFromTridiagonal(Eigen::VectorXd(projected_.diagonal().head(n)),
                                 Eigen::VectorXd(projected_.diagonal(1).head(n - 1)), options);
    return eigen;
  }
  static std::vector<int> largest(const Eigen::VectorXd& values, int count) {
    std::vector<int> order(std::size_t(values.size()));
    std::iota(order.begin(), order.end(), 0);
    std::ranges::sort(order, std::greater{}, [&](int i) { return std::abs(values[i]); });
    order.resize(std::min(order.size(), std::size_t(count)));
    return order;
  }

  const Apply& apply_;
  const Mass& mass_;
  Eigen::VectorXd next_;
  std::vector<Eigen::VectorXd> basis_, loaded_;  // and the mass times its vectors
  Eigen::MatrixXd projected_;
};

/// The `count` eigenvalues of largest absolute value, and vectors, of x → apply(mass x), which is symmetric in
/// (x, mass y); fewer where the space that `start` spans has no more. Full reorthogonalisation: O(n steps²). Empty
/// where `most` steps do not suffice to leave the values unchanged within `tolerance` of the largest, or where a vector
/// is not finite.
template <class Apply, class Mass>
std::optional<RitzPairs> largest_by_lanczos(const Apply& apply, const Mass& mass,
                                            const Eigen::VectorXd& start, int count, int most,
                                            double tolerance = 1e-10) {
  KrylovSpace<Apply, Mass> space(apply, mass, start, most);
  Eigen::VectorXd before;
  for (int k = 0; k < most; ++k) {
    const bool exhausted = !space.extend();
    if (!exhausted && space.size() < count + 3) continue;
    Eigen::VectorXd values = space.values(count);
    if (!values.allFinite()) return {};
    const bool settled = before.size() == values.size()
                      && (values - before).cwiseAbs().maxCoeff() <= tolerance * std::abs(values[0]);
    if (exhausted || settled) return space.pairs(count);
    before = std::move(values);
  }
  return {};
}

}  // namespace sbeh::model
