// What lies beyond the fold in which the smooth ordered oblate ends: the saddle back from it, and the
// states with a sharp rim.
//
// All on half curves symmetric top to bottom with elements of high degree that shrink towards the rim
// (rim/basis.h), for the one-constant approximation.
#pragma once

#include "axisym/curve.h"
#include "model/material.h"
#include "model/names.h"

#include <array>
#include <optional>
#include <span>
#include <vector>

namespace sbeh::axisym {

enum class RimKind {
  fold,           ///< where the smooth oblate ends as L grows
  saddle,         ///< the barrier between smooth and sharp, from the fold back to smaller L
  second_fold,    ///< where the states with a sharp rim end as L falls
  sharp,          ///< a minimum with a sharp rim
  equal_energy,   ///< the sharp state at the L at which the smooth one has its energy
  nested_spheres  ///< no state but what stomatocytes tend to, see nested_spheres.h
};
constexpr auto names(RimKind) {
  return std::array{"fold", "saddle", "second_fold", "sharp", "equal_energy", "nested_spheres"};
}

/// A stationary state with its rim; lengths in radii of the sphere of equal area.
struct RimRecord {
  RimKind kind;
  double reduced_volume, L, energy;
  /// β at the rim; 0: a kink, or below 1e-5, which counts as one.
  double order_rim;
  double H_rim, H_abs_max;  ///< −∞ and ∞ at a kink
  /// Turn of the tangent within 1e-4 of the rim, both sides, in radians.
  double jump;
  /// Largest change between neighbouring nodes of the tangent's angle in radians, or of β as a share of
  /// 2/3; above 0.35 the state is not resolved.
  double resolution;
  double pressure;  ///< P = ∂U/∂V at fixed area
  /// Axisymmetric ones in which U falls, a kink staying one; at a fold: on its stable side. None of a limit.
  std::optional<int> negative_directions;
  State state;  ///< the whole curve, see profile_of of rim/path.h
};

/// The states at one reduced volume: the fold, the saddle and the sharp state at those of the L (ascending)
/// where they exist, the second fold, and the sharp state of the smooth one's energy; by kind, then by L.
/// Empty when the oblate has no fold below L = 2, or is lost on the way. No sharp states with a residual
/// stiffness, which makes a kink infinitely costly. About two seconds.
/// Throws std::invalid_argument unless 0.51 < V_r < 1.
std::vector<RimRecord> beyond_fold(const model::Material& material, double reduced_volume,
                                   std::span<const double> L);

}  // namespace sbeh::axisym
