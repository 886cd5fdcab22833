// The Gaussian energy ∫ κ_G(β) K dS on a surface of curved triangles that meet in edges and corners.
//
// With K dS = −dω, ω the connection form of the frame of a triangle, an edge's jump of geodesic curvature and a
// corner's defect of angle counted as curvature, and everything integrated by parts along the triangle's rim:
//
//   ∫ κ_G K = Σ_corners (2π − (π/3) valence) κ_G + Σ_triangles [ ∫ dκ_G ∧ ω − ∫_1→2 (ψ − 2π/3) dκ_G + ∫_0→2 (φ − π/3) dκ_G ]
//
// φ, ψ the angles from a1 to a2 and to a2 − a1. Gauss and Bonnet's theorem holds exactly: where κ_G is constant nothing but
// 4π κ_G is left. Where positions are O(h⁴) off, and smoothly so, the energy is.
#pragma once

#include "model/material.h"

#include <array>
#include <cmath>
#include <numbers>

namespace sbeh::surface3d {

/// What it reads at a point; a_i, a_ij are derivatives of the position by the triangle's coordinates.
enum GaussianData {
  of_g11,
  of_g12,
  of_g22,
  of_beta,
  of_beta_1,
  of_beta_2,
  of_a11_a1,
  of_a11_a2,
  of_a12_a1,
  of_a12_a2,
  gaussian_data
};
inline constexpr int rim_data = of_a11_a1;
template <class T>
using GaussianFields = std::array<T, gaussian_data>;
template <class T>
using RimFields = std::array<T, rim_data>;

/// dκ_G ∧ ω per dξ₁dξ₂.
template <class T>
T connection_density(const model::Material& material, const GaussianFields<T>& q) {
  using std::sqrt;
  const T &g11 = q[of_g11], &g12 = q[of_g12], &g22 = q[of_g22];
  const T part = g12 / g11;
  const T omega_1 = q[of_a11_a2] - part * q[of_a11_a1];  // times √g
  const T omega_2 = q[of_a12_a2] - part * q[of_a12_a1];
  return material.kappa_gauss_slope(q[of_beta]) * (q[of_beta_1] * omega_2 - q[of_beta_2] * omega_1)
       / sqrt(g11 * g22 - g12 * g12);
}

/// The angle in (0, π) between vectors of lengths² g11 and g22 with the product g12.
template <class T>
T angle_between(const T& g11, const T& g12, const T& g22) {
  using std::atan, std::sqrt;
  return 2. * atan(sqrt(g11 * g22 - g12 * g12) / (sqrt(g11 * g22) + g12));
}

/// (φ − π/3) dκ_G per dξ₂, on the edge 0→2.
template <class T>
T first_rim_density(const model::Material& material, const RimFields<T>& q) {
  return (angle_between(q[of_g11], q[of_g12], q[of_g22]) - std::numbers::pi / 3)
       * material.kappa_gauss_slope(q[of_beta]) * q[of_beta_2];
}

/// −(ψ − 2π/3) dκ_G per −dξ₁, on the edge 1→2.
template <class T>
T second_rim_density(const model::Material& material, const RimFields<T>& q) {
  const T &g11 = q[of_g11], &g12 = q[of_g12];
  return (2 * std::numbers::pi / 3
          - angle_between(g11, T(g12 - g11), T(g11 - 2. * g12 + q[of_g22])))
       * material.kappa_gauss_slope(q[of_beta]) * (q[of_beta_2] - q[of_beta_1]);
}

}  // namespace sbeh::surface3d
