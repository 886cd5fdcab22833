// Stationary shapes of the bending energy by minimisation over spherical harmonics, without an axis: a
// witness in 3D that shares nothing with the finite elements but the energy per area.
//
// Ceres minimises ½∫H² dS as a sum of squares with shifted penalties on area and volume (augmented
// Lagrangian) over all coefficients of harmonic_surface.h; Newton's method with the exact second variation
// takes the result to rounding and counts the directions in which the energy falls. Relative errors of
// the energy with degree 16: 1e-8 at V_r = 0.8, 3e-6 at V_r = 0.65, in a second.
#pragma once

#include "surface3d/harmonic/surface.h"

#include <string>

namespace sbeh::surface3d {

enum class HarmonicStop {
  stationary,    ///< Newton's method has converged
  degenerate,    ///< the surface turned inside out: it has left the reach of its coordinates
  not_converged  ///< nor did Newton's method converge
};
std::string describe(HarmonicStop stop);

/// A shape of SSH without spontaneous curvature, in units of the sphere of equal area: R = 1, A = 4π.
/// Values other than the surface are those of a stationary shape.
struct HarmonicState {
  HarmonicStop stop = HarmonicStop::not_converged;
  HarmonicSurface surface;
  double energy = 0;    ///< F/(8πκ), F = (κ/2)∫H² dS: 1 on the sphere
  double pressure = 0;  ///< P R³/κ, P = ∂F/∂V at fixed area
  double tension = 0;   ///< Σ R²/κ, Σ = −∂F/∂A at fixed volume; 3PV = 2ΣA
  /// Directions of negative second variation at fixed area and volume, rigid motions apart: 0 for a
  /// minimum. The oblate of V_r = 0.8 has two.
  int negative_directions = 0;
  double stiffness = 0;  ///< smallest eigenvalue of that variation, per square of the coefficients
};

/// The stationary shape of A = 4π and this reduced volume next to the start, which need not have them. Of a
/// saddle near by Newton's method finds the saddle: see negative_directions.
/// Harmonics of l <= degree; the time grows like degree⁶.
/// Throws std::invalid_argument unless 0 < V_r < 1 and 4 <= degree <= 32.
HarmonicState minimise_harmonics(const HarmonicSurface& start, double reduced_volume,
                                 int degree = 16);

/// By Newton's method alone, from a start near the shape, be it a saddle: to go along a branch. The same exceptions.
HarmonicState stationary_harmonics(const HarmonicSurface& start, double reduced_volume,
                                   int degree = 16);

}  // namespace sbeh::surface3d
