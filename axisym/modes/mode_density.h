// The Lagrangian of a stationary state at a point of any surface that is given over the element's coordinate ξ
// and the angle φ: what the second variation by u(s) cos mφ needs and the axisymmetric one cannot say.
//
//   𝓛 = ∫ [ U(X, β, H) + Σ n/n(2/3) ] dS − P V + (H ν, Λ) + (1, Div_C Λ)
//
// as in stationary/stationary.h. The Gaussian curvature is that of B_φφ and B_ξφ, which need one derivative by ξ
// only, and of the B_ξξ that H leaves: on a surface of revolution B_φφ (H − B_φφ), as there.
#pragma once

#include "model/energy_density.h"

#include <array>
#include <cmath>

namespace sbeh::axisym {

/// What the density reads, in the frame (e_r, e_φ, e_z) that turns with φ; _xi and _phi are derivatives. The
/// position is r e_r + z e_z; it has no part along e_φ, its derivatives by φ are those of r and z. Λ comes last,
/// since the Lagrangian is linear in it.
enum ModeData {
  in_r,
  in_r_xi,
  in_z_xi,
  in_r_phi,
  in_z_phi,
  in_r_xi_phi,
  in_z_xi_phi,
  in_r_phi_phi,
  in_z_phi_phi,
  in_H,
  in_beta,
  in_beta_xi,
  in_beta_phi,
  in_Lambda_r,
  in_Lambda_z,
  in_Lambda_r_xi,
  in_Lambda_z_xi,
  in_Lambda_r_phi,
  in_Lambda_z_phi,
  mode_data
};
inline constexpr int nonlinear_mode_data = in_Lambda_r;
template <class T>
using ModeFields = std::array<T, nonlinear_mode_data>;

/// 𝓛 = energy + Λ_r c_0 + Λ_z c_1 + Λ_r,ξ c_2 + Λ_z,ξ c_3 + Λ_r,φ c_4 + Λ_z,φ c_5 per dξ dφ.
template <class T>
struct ModeDensity {
  T energy;
  std::array<T, 6> curvature;
};

template <class T>
ModeDensity<T> mode_density(const model::Material& material, double tension, double pressure,
                            const ModeFields<T>& q) {
  using std::sqrt;
  // First derivatives of the position: (r_ξ, 0, z_ξ) and (r_φ, r, z_φ).
  const T &r = q[in_r], &r_xi = q[in_r_xi], &z_xi = q[in_z_xi], &r_phi = q[in_r_phi],
          &z_phi = q[in_z_phi];
  const T E = r_xi * r_xi + z_xi * z_xi;
  const T F = r_xi * r_phi + z_xi * z_phi;
  const T G = r_phi * r_phi + r * r + z_phi * z_phi;
  const T g = E * G - F * F;
  const T dS = sqrt(g);

  // X_ξ × X_φ = √g ν, second derivatives (r_ξφ, r_ξ, z_ξφ) and (r_φφ − r, 2 r_φ, z_φφ).
  const T N_r = -1. * z_xi * r, N_phi = z_xi * r_phi - r_xi * z_phi, N_z = r_xi * r;
  const T B_xi_phi = (q[in_r_xi_phi] * N_r + r_xi * N_phi + q[in_z_xi_phi] * N_z) / dS;
  const T B_phi_phi =
      ((q[in_r_phi_phi] - r) * N_r + 2. * r_phi * N_phi + q[in_z_phi_phi] * N_z) / dS;
  const T B_xi_xi = (q[in_H] * g + 2. * F * B_xi_phi - E * B_phi_phi) / G;
  const T K = (B_xi_xi * B_phi_phi - B_xi_phi * B_xi_phi) / g;

  const T &beta = q[in_beta], &beta_xi = q[in_beta_xi], &beta_phi = q[in_beta_phi];
  const T slope_squared =
      (G * beta_xi * beta_xi - 2. * F * beta_xi * beta_phi + E * beta_phi * beta_phi) / g;
  const auto e = model::energy_density(material, beta, slope_squared, q[in_H], K);

  const T volume = -0.5 * r * r * z_xi;  // ½ (r e_r, X_ξ × X_φ)
  return {
      .energy = dS * (e.total() + model::tension_at(material, tension, beta)) - pressure * volume,
      .curvature = {E * r / dS + q[in_H] * N_r,    // (H ν + Div_C, Λ_r)
                    q[in_H] * N_z,                 // (H ν, Λ_z)
                    (G * r_xi - F * r_phi) / dS,   // ∂_ξ Λ_r
                    (G * z_xi - F * z_phi) / dS,   // ∂_ξ Λ_z
                    (E * r_phi - F * r_xi) / dS,   // ∂_φ Λ_r
                    (E * z_phi - F * z_xi) / dS},  // ∂_φ Λ_z
  };
}

}  // namespace sbeh::axisym
