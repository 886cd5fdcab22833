// What up-down symmetry spares: the modes of a symmetric state have a parity, so that its upper half says all.
#pragma once

#include "axisym/curve.h"
#include "model/numerics/chain_matrix.h"

#include <vector>

namespace sbeh::axisym {

/// Whether a mode of an up-down symmetric state goes into itself upside down (even), or into its negative.
enum class Parity { even, odd, none };
constexpr auto names(Parity) { return std::array{"even", "odd", "none"}; }

/// The elements, from the north pole on, over which modes are computed: all of a state, or of a symmetric one its
/// upper half, with the element that the equator cuts where their number is odd.
struct Sector {
  int state_elements;
  bool is_half;

  int elements() const { return is_half ? (state_elements + 1) / 2 : state_elements; }
  /// Those that are the state's: beyond the equator a cut element's are mirror images.
  int nodes() const { return is_half ? (3 * state_elements + 2) / 2 : 3 * state_elements + 1; }
  bool cuts_an_element() const { return is_half && state_elements % 2 == 1; }
  /// How many of the state's elements e stands for.
  double copies(int e) const {
    return is_half && !(cuts_an_element() && e + 1 == elements()) ? 2 : 1;
  }
  std::vector<Parity> parities() const {
    return is_half ? std::vector{Parity::even, Parity::odd} : std::vector{Parity::none};
  }
  /// A field over the whole state.
  Field whole(const Field& part, Parity parity) const {
    if (!is_half) return part;
    const Eigen::Index all = 3 * state_elements + 1, given = nodes();
    Field field(all);
    field.head(given) = part.head(given);
    field.tail(all - given) = (parity == Parity::even ? 1 : -1) * part.head(all - given).reverse();
    return field;
  }
};

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
