// The methods that find a stationary state, or follow an evolution, independently of each other.
#pragma once

#include "model/names.h"
#include "surface3d/options.h"

#include <array>
#include <string>

namespace sbeh::studies {

/// A way to a stationary state, or along an evolution.
enum class Witness {
  newton,        ///< Newton's method on finite elements of the generating curve
  shooting,      ///< shape equations by Boost.Odeint; SSH without spontaneous curvature
  minimiser,     ///< spectral curves, Ceres and Newton; SBEH or SSH
  flow,          ///< the axisymmetric solver, in time from an ellipsoid to rest
  surface3d,     ///< the 3D solver, in time, to rest
  states,        ///< Newton's method in 3D, from the revolved state of `newton`
  harmonics,     ///< spherical harmonics without an axis, Ceres and Newton; SSH, V_r >= 0.65
  harmonic_flow  ///< spherical harmonics without an axis, in time by Boost.Odeint; of evolutions
};
constexpr auto names(Witness) {
  return std::array{"newton",    "shooting", "minimiser", "flow",
                    "surface3d", "states",   "harmonics", "harmonic_flow"};
}

/// Whether its surface has no axis to begin with.
constexpr bool is_in_3d(Witness witness) {
  return witness == Witness::surface3d || witness == Witness::states
      || witness == Witness::harmonics || witness == Witness::harmonic_flow;
}

/// Whether it follows an evolution in 3D.
constexpr bool follows_evolutions(Witness witness) {
  return witness == Witness::surface3d || witness == Witness::harmonic_flow;
}

/// How the 3D solver is used: table [surface3d].
struct SurfaceMethod {
  std::string run;        ///< folder of a run (sbeh run), whose last frame is taken; or empty
  bool revolved = false;  ///< key `start`: "ellipsoid" of full order, or "revolved": Newton's state
  int triangles = 320;    ///< about so many
  double end_time = 20;   ///< key `end`, > 0: a flow that is not at rest ends here
  surface3d::Numerics numerics;  ///< keys `tolerance` (1e-3) and `rest_speed` (1e-5)
  SurfaceMethod() {
    numerics.tolerance = 1e-3;
    numerics.rest_speed = 1e-5;
  }

  bool operator==(const SurfaceMethod&) const = default;
};

/// How the harmonics are used: table [harmonics].
struct HarmonicMethod {
  int degree = 16;  ///< largest l, 8 <= degree <= 24

  bool operator==(const HarmonicMethod&) const = default;
};

/// How harmonics follow an evolution: table [harmonic_flow].
struct HarmonicFlowMethod {
  int degree = 12;          ///< largest l, 6 <= degree <= 24
  double tolerance = 1e-8;  ///< of a step, 1e-12 … 1e-3

  bool operator==(const HarmonicFlowMethod&) const = default;
};

}  // namespace sbeh::studies
