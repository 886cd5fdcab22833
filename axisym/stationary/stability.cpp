#include "axisym/stationary/stability.h"

#include "axisym/stationary/newton_system.h"

#include <Eigen/Eigenvalues>

namespace sbeh::axisym {

namespace {

constexpr int global_multipliers = 4;     // tension, pressure, moment, chemical potential
constexpr int block = 3 * node_unknowns;  // an element without its last node
using Block = Eigen::Matrix<double, block, block>;
using Border = Eigen::Matrix<double, block, global_multipliers>;
using Corner = Eigen::Matrix<double, global_multipliers, global_multipliers>;

// Counts negative eigenvalues while eliminating the blocks of a symmetric block tridiagonal matrix
// with a few border columns.
class InertiaCounter {
 public:
  explicit InertiaCounter(const Corner& corner) : corner_(corner) {}
  // `below` couples the block to the next one.
  void eliminate(const Block& diagonal, const Block& below, const Border& border) {
    const Block pivot = diagonal - coupling_ * carried_;
    const Border b = border - coupling_ * carried_border_;
    const Eigen::SelfAdjointEigenSolver<Block> eigen(pivot);
    negative_ += int((eigen.eigenvalues().array() < 0).count());
    const Block inverse = eigen.eigenvectors() * eigen.eigenvalues().cwiseInverse().asDiagonal()
                        * eigen.eigenvectors().transpose();
    corner_ -= b.transpose() * inverse * b;
    coupling_ = below;
    carried_ = inverse * below.transpose();
    carried_border_ = inverse * b;
  }
  int finish() {
    const Eigen::SelfAdjointEigenSolver<Corner> eigen(corner_);
    return negative_ + int((eigen.eigenvalues().array() < 0).count());
  }

 private:
  Block coupling_ = Block::Zero(), carried_ = Block::Zero();
  Border carried_border_ = Border::Zero();
  Corner corner_;
  int negative_ = 0;
};

}  // namespace

int negative_directions(const model::Material& material, model::Model model,
                        const StationaryState& state) {
  return negative_directions(lagrangian_at(material, model, state), material, model);
}

int negative_directions(const LagrangianDerivatives& lagrangian, const model::Material& material,
                        model::Model model) {
  const int size = int(lagrangian.gradient.size()), nodes = size / node_unknowns;
  // Pinned unknowns leave the matrix symmetrically; a 1 on the diagonal counts as no negative.
  std::vector<bool> pinned(std::size_t(size), false);
  for_each_pinned(model, lagrangian.sector, [&](int i) { pinned[std::size_t(i)] = true; });
  const auto entry = [&](int i, int j) {
    if (i >= size || j >= size || pinned[std::size_t(i)] || pinned[std::size_t(j)])
      return i == j ? 1. : 0.;
    return std::abs(i - j) <= lagrangian.hessian.half_width() ? lagrangian.hessian(i, j) : 0.;
  };

  // Without an area difference nothing couples to the moment, whose 1 counts as no negative; likewise the order.
  const model::AreaDifference& ad = material.area_difference;
  const bool conserves = has_free_order(model) && material.conserves_order();
  Corner corner = Corner::Zero();
  corner(2, 2) = ad.is_there() ? -ad.compliance() * lagrangian.area : 1;
  corner(3, 3) = conserves ? 0 : 1;
  InertiaCounter counter(corner);
  const int blocks = (size + block - 1) / block;  // the last one is padded
  for (int k = 0; k < blocks; ++k) {
    Block diagonal, below;
    Border border;
    for (int i = 0; i < block; ++i) {
      const int row = block * k + i;
      for (int j = 0; j < block; ++j) {
        diagonal(i, j) = entry(row, block * k + j);
        below(i, j) = entry(row + block, block * k + j);
      }
      const bool is_free = row < size && !pinned[std::size_t(row)];
      for (int c = 0; c < 2; ++c) border(i, c) = is_free ? lagrangian.constraints(row, c) : 0;
      border(i, 2) = is_free ? lagrangian.of_W2[row] : 0;
      border(i, 3) = is_free ? lagrangian.of_order[row] : 0;
    }
    counter.eliminate(diagonal, below, border);
  }
  return counter.finish() - nodes - 2 - (ad.is_there() ? 1 : 0) - (conserves ? 1 : 0);
}

}  // namespace sbeh::axisym
