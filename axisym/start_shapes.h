// Shapes to start from: spheroids and nearly spherical shapes, scaled to the area of the unit sphere.
#pragma once

#include "axisym/curve.h"

#include <functional>
#include <span>
#include <utility>

namespace sbeh::axisym {

/// Amplitude of a zonal harmonic Y_l(θ) = √((2l + 1)/4π) P_l(cos θ), orthonormal on the sphere.
struct Mode {
  int l;
  double amplitude;

  bool operator==(const Mode&) const = default;
};

/// Nodes on the curve θ ↦ (r, z), θ ∈ [0, π] from pole to pole, the cubics through its Gauss–Lobatto
/// points, graded by curvature as in `redistribute`, then scaled to area 4π.
Nodes nodes_on(const std::function<Eigen::Vector2d(double)>& curve, int elements, double grading);

/// Spheroid with these semi-axes, scaled. Throws std::invalid_argument unless both are > 0.
Nodes spheroid(double equatorial, double polar, int elements, double grading);

/// Oblate (or prolate) spheroid of area 4π and this reduced volume, 0 < V_r <= 1, met by the curve of
/// elements itself. Throws std::invalid_argument outside, and where it is too flat or thin for the
/// elements.
Nodes spheroid(double reduced_volume, bool prolate, int elements, double grading);

/// r(θ) = 1 + Σ u_l Y_l(θ), scaled. Throws std::invalid_argument where r <= 0 or for l < 0.
Nodes harmonic_sphere(std::span<const Mode> modes, int elements, double grading);

/// The same with all amplitudes multiplied by one factor > 0, so that the curve of elements itself has this
/// reduced volume. Throws std::invalid_argument unless 0 < V_r < 1, and where r would reach 0 first.
Nodes harmonic_sphere(std::span<const Mode> modes, double reduced_volume, int elements,
                      double grading);

/// The curve displaced along its normals by Σ a_l Y_l of the directions from its middle; area and volume are brought back to what they were, but for a sphere, which shares its volume
/// with no other shape: there the area alone. Throws std::invalid_argument where that is too large for
/// the curve.
Nodes perturbed(const Nodes& X, std::span<const Mode> modes);

/// Σ b_l Y_l at the polar angle θ.
double zonal_sum(std::span<const Mode> modes, double theta);

}  // namespace sbeh::axisym
