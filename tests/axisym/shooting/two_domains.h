// Vesicles of two domains with a sharp interface, by shooting: a witness of those whose order has two phases.
//
// Jülicher and Lipowsky, Phys. Rev. E 53 (1996) 2670. Domain a is a cap around the north pole, b the rest. With A = 4π, H the trace,
// no spontaneous curvature and Δ = κ_G,a − κ_G,b the energy, but for the constant 4πκ_G,b, is
//   U = (κ_a/2) ∫_a H² dS + (κ_b/2) ∫_b H² dS + Δ ∫_a K dS + 2πλX,      ∫_a K dS = 2π(1 − cos ψ_a).
// Each domain is integrated from its own pole by the equations of axisym/shooting/shape_equations.h in units of its own κ: their γ, Σ,
// P are γ_i/κ_i, Σ_i/κ_i, P/κ_i of domain i. P is one, Σ_a and Σ_b are two, for both areas are given. Integrated by parts, the variation
// of U + Σ_a A_a + Σ_b A_b − PV over 2π has at the interface, where ψ and X are those of either piece as seen from its own pole,
//   δψ_a (−κ_a X H_a + Δ sin ψ_a) + δψ_b (−κ_b X H_b) + γ_a δX_a + γ_b δX_b + λ δX,
// with δψ_b = −δψ_a (the tangent is continuous) and δX_a = δX_b = δX. So
//   X (κ_a H_a − κ_b H_b) = Δ sin ψ_a      the meridional moment is continuous,
//   γ_a + γ_b + λ = 0                      the force across the axis jumps by the line tension.
// Along the axis nothing is left to vary; the lengths of both pieces are free, so that h = 0 in each, as the poles make it. Seven
// unknowns, H at both poles, both lengths, Σ_a, Σ_b, P, are found from these two and
//   ψ_a + ψ_b = π,   X_a = X_b,   A_a = 4πx,   A_b = 4π(1 − x),   V_a + V_b = (4π/3) V_r.
#pragma once

#include <span>

namespace sbeh::axisym::shooting {

/// Lengths in radii of the sphere of the same area.
struct TwoDomains {
  double fraction;  ///< x of domain a, of the area, 0 … 1
  double kappa_a = 1, kappa_b = 1;
  double gauss_jump = 0;  ///< Δ = κ_G,a − κ_G,b
  double line_tension = 0;
  double reduced_volume;
};

/// One at rest.
struct TwoDomainVesicle {
  double reduced_volume;
  bool is_fold;   ///< along V_r
  double energy;  ///< U as above
  double pressure, tension_a, tension_b;
  double interface_radius;  ///< X
  double interface_angle;   ///< ψ_a: π/2 where the interface is at the neck
  double neck_radius;       ///< where X is least between the poles; infinite without a neck
  double
      neck_offset;  ///< arc length from there to the interface, > 0 where that lies towards the pole of b
};

/// Where a path leads: from the prolate of V_r = 0.95 whose domains do not differ, but have the fraction of the first, to each of
/// these by straight lines. On the last only V_r changes; where it has a fold, that is the result. Throws std::runtime_error where
/// another has one, and where shooting cannot follow: to narrow necks under a large pressure.
TwoDomainVesicle vesicle_along(std::span<const TwoDomains> way);

/// That by the way of these domains at V_r = 0.95.
TwoDomainVesicle open_vesicle(const TwoDomains& of);

}  // namespace sbeh::axisym::shooting
