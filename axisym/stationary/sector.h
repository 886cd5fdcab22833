// What up-down symmetry spares: the modes of a symmetric state have a parity, so that its upper half says all.
#pragma once

#include "axisym/curve.h"

#include <array>
#include <vector>

namespace sbeh::axisym {

/// Whether a mode of an up-down symmetric state goes into itself upside down (even), or into its negative.
enum class Parity { even, odd, none };
constexpr auto names(Parity) { return std::array{"even", "odd", "none"}; }

/// The elements, from the north pole on, over which a state and its modes are computed: all of them, or of a symmetric
/// state its upper half, with the element that the equator cuts where their number is odd.
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
  /// The node, or its mirror image if that is the sector's.
  int folded(int node) const { return node < nodes() ? node : 3 * state_elements - node; }
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

}  // namespace sbeh::axisym
