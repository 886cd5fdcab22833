// Matrices and loads over a sector, of modes of one parity.
#pragma once

#include "axisym/stationary/sector.h"
#include "model/numerics/chain_matrix.h"

namespace sbeh::axisym {

/// What a node's unknowns are multiplied by where an even mode is turned upside down.
template <int N>
using Mirror = Eigen::Matrix<double, N, 1>;

/// Visits the unknowns that a parity does not leave free at the equator and beyond it.
template <int N, class Visit>
void for_each_mirrored(const Sector& sector, Parity parity, const Mirror<N>& even, Visit&& visit) {
  if (!sector.is_half) return;
  const int first = sector.nodes(), last = 3 * sector.elements();
  for (int node = first; node <= last; ++node)
    for (int c = 0; c < N; ++c) visit(N * node + c);
  if (sector.cuts_an_element()) return;
  for (int c = 0; c < N; ++c)
    if ((even[c] < 0) == (parity == Parity::even)) visit(N * last + c);
}

/// Adds what acts beyond the equator to what acts on its mirror image.
template <int N>
void fold(const Sector& sector, Parity parity, const Mirror<N>& even,
          model::ChainMatrix<N>& matrix) {
  if (!sector.cuts_an_element()) return;
  const Mirror<N> sign = parity == Parity::even ? even : Mirror<N>(-even);
  auto& element = matrix.element(sector.elements() - 1);
  for (const int a : {0, 1}) {
    element.template middleRows<N>(N * a) +=
        sign.asDiagonal() * element.template middleRows<N>(N * (3 - a));
    element.template middleRows<N>(N * (3 - a)).setZero();
  }
  for (const int a : {0, 1}) {
    element.template middleCols<N>(N * a) +=
        element.template middleCols<N>(N * (3 - a)) * sign.asDiagonal();
    element.template middleCols<N>(N * (3 - a)).setZero();
  }
}
template <int N>
void fold(const Sector& sector, Parity parity, const Mirror<N>& even, Eigen::VectorXd& load) {
  if (!sector.cuts_an_element()) return;
  const double sign = parity == Parity::even ? 1 : -1;
  const Eigen::Index last = 3 * Eigen::Index(sector.elements());
  for (const int a : {0, 1}) {
    load.segment<N>(N * (last - 3 + a)) +=
        sign * even.cwiseProduct(load.segment<N>(N * (last - a)));
    load.segment<N>(N * (last - a)).setZero();
  }
}

}  // namespace sbeh::axisym
