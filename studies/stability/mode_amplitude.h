// How far a surface is from one of revolution about z, mode by mode.
#pragma once

#include "model/names.h"
#include "surface3d/surface.h"

namespace sbeh::studies {

/// √(q_lm² + q_l−m²) with q_lm = ∫ r^l Y_lm dS / ∫ r^l dS, r and Y_lm about the centre of area, m >= 1: 0 for a
/// surface of revolution about z, and the same when the surface is turned about z. A small normal
/// displacement of order m changes it to first order; others, to second. With m = 1 and odd l >= 3 a small turn
/// of a surface that is symmetric top to bottom does not change it.
double mode_amplitude(const surface3d::Triangulation& mesh, const surface3d::Nodes& X, int l,
                      int m);

/// What kind of body the principal second moments of the surface make it.
enum class Roundness {
  oblate,   ///< two large ones are equal
  prolate,  ///< two small ones are equal
  triaxial  ///< no two
};
constexpr auto names(Roundness) { return std::array{"oblate", "prolate", "triaxial"}; }
/// Two moments count as equal when they differ by less than 5 % of the range of all three.
Roundness roundness_of(const surface3d::Triangulation& mesh, const surface3d::Nodes& X);

}  // namespace sbeh::studies
