// The largest eigenvalues of a symmetric operator, several alike among them: Lanczos' iteration by blocks.
#pragma once

#include "model/numerics/lanczos.h"

#include <Eigen/Cholesky>
#include <Eigen/QR>

namespace sbeh::model {

/// The `count` eigenvalues of largest absolute value, and vectors, of x → apply(mass x), which is symmetric in (x, mass y);
/// apply and mass take columns. `start` has as many columns as an eigenvalue may have vectors, or more: one that has
/// more is found with fewer. Full reorthogonalisation. Empty where `most` vectors do not suffice to leave the values unchanged within
/// `tolerance` of themselves, or where one is not finite.
template <class Apply, class Mass>
std::optional<RitzPairs> largest_by_block_lanczos(const Apply& apply, const Mass& mass,
                                                  Eigen::MatrixXd start, int count, int most,
                                                  double tolerance = 1e-9) {
  Eigen::MatrixXd basis(start.rows(), 0), loaded(start.rows(), 0), projected(0, 0);
  Eigen::VectorXd before;
  Eigen::MatrixXd next = std::move(start);
  while (true) {
    // Orthonormal in the mass, to the basis too; twice against rounding.
    Eigen::MatrixXd with_mass;
    for (int pass = 0; pass < 2; ++pass) {
      next -= basis * (loaded.transpose() * next);
      with_mass = mass(next);
      const Eigen::MatrixXd gram = next.transpose() * with_mass;
      const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> lengths(gram);
      const double largest = lengths.eigenvalues().tail<1>()[0];
      if (!std::isfinite(largest)) return {};
      const Eigen::Index kept = (lengths.eigenvalues().array() > 1e-20 * largest).count();
      const Eigen::MatrixXd turn =
          lengths.eigenvectors().rightCols(kept)
          * lengths.eigenvalues().tail(kept).cwiseSqrt().cwiseInverse().asDiagonal();
      next = (next * turn).eval();
      with_mass = (with_mass * turn).eval();
    }
    const Eigen::Index old = basis.cols(), all = old + next.cols();
    basis.conservativeResize(Eigen::NoChange, all);
    loaded.conservativeResize(Eigen::NoChange, all);
    basis.rightCols(next.cols()) = next;
    loaded.rightCols(next.cols()) = with_mass;
    next = apply(with_mass);
    projected.conservativeResize(all, all);
    projected.rightCols(all - old) = loaded.transpose() * next;
    projected.bottomLeftCorner(all - old, old) =
        projected.topRightCorner(old, all - old).transpose();

    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(projected);
    std::vector<int> order(std::size_t(all), 0);
    std::iota(order.begin(), order.end(), 0);
    std::ranges::sort(order, std::greater{},
                      [&](int i) { return std::abs(eigen.eigenvalues()[i]); });
    order.resize(std::min(order.size(), std::size_t(count)));
    const Eigen::VectorXd values = eigen.eigenvalues()(order);
    if (!values.allFinite()) return {};
    if (before.size() == count
        && ((values - before).array().abs() <= tolerance * values.array().abs()).all())
      return RitzPairs{values, basis * eigen.eigenvectors()(Eigen::all, order),
                       eigen.eigenvalues()[0]};
    if (all + next.cols() > most) return {};
    before = values;
  }
}

}  // namespace sbeh::model
