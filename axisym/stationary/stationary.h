// Stationary states by Newton's method: critical points of the energy at fixed area and volume.
//
// The discrete Lagrangian is the energy of model/energy_density.h on the P3 curve, with the mean
// curvature a P3 field H bound to the curve by the scheme's curvature equation (H1):
//   𝓛 = U(X, β, H) + [(H ν, Λ) + (1, Div_C Λ)] + Σ (A − A₀) − P (V − V₀).
// With an area difference (model/material.h) the moment c is one more number:
//   … + c (W₂ − W₂⁰) − c² A/(2π k_ad),
// which acts as f + c for f, and as Σ − c²/(2π k_ad) for Σ. Where the order is conserved the chemical potential is one, too:
//   … − μ_β (∫β dS − β̄ A),
// which acts as u − μ_β(β − β̄) for u.
// The curve moves along its node normals, X + Σ d_i φ_i n_i, and the multiplier is Λ = Σ Λ_i φ_i n_i;
// the north pole is held to fix the position along the axis. All derivatives come from automatic
// differentiation of the one pointwise density, so that residual and matrix cannot disagree and the
// matrix is symmetric. dU/dL = U_EL/L holds along the discrete branch to the order of the energy: the
// normals turn with the curve, which the derivatives leave out.
#pragma once

#include "axisym/time_step.h"

#include <limits>

namespace sbeh::axisym {

enum class NewtonStatus { converged, diverged, singular };

struct NewtonResult {
  NewtonStatus status;
  StationaryState state;  ///< the last iterate
  int iterations;
  int determinant_sign;  ///< of the bordered matrix; constant along a branch, flips at a fold
};

struct NewtonOptions {
  int most_iterations = 12;
  double tolerance =
      1e-8;  ///< on the largest change of position and order; the next would be a small share of it
  double longest_step = 0.15;  ///< larger displacements are shortened to it
  double far =
      std::numeric_limits<double>::infinity();  ///< a larger change leaves the neighbourhood
  bool corrects = true;  ///< the last step by another one with the same matrix
  bool symmetric =
      false;  ///< the guess is symmetric top to bottom, and only such states are looked for
};

/// What the Lagrangian has of a material: all of it where the order is free; where it is uniform no Gaussian energy,
/// which is a constant, and whose parts would outweigh all others in narrow necks.
model::Material felt_material(const model::Material& material, model::Model model);

/// With what the state's moment and chemical potential make of it.
model::Material held_material(const model::Material& material, const StationaryState& state);

/// Σ − c²/(2π k_ad), what multiplies the area in the Lagrangian.
double felt_tension(const model::Material& material, const StationaryState& state);

/// Completes position and order to a guess: H from the curve, Λ from H, tension, pressure and moment by least
/// squares on the force balance.
StationaryState guess_from(const model::Material& material, model::Model model, const State& shape);

/// Largest force (normal) or order residual per area of its node: 0 at an exact solution.
double residual_of(const model::Material& material, model::Model model,
                   const StationaryState& state);

/// Newton on the Lagrangian at the area and volume of `target`, starting from `guess`.
NewtonResult solve_stationary(const model::Material& material, model::Model model,
                              const Target& target, const StationaryState& guess,
                              const NewtonOptions& options = {});

}  // namespace sbeh::axisym
