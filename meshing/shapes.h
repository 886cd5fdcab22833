// Shapes given by a formula as curved meshes: spheres, ellipsoids, spherical harmonics, and any
// surface that is star-shaped about the origin. Every node lies on the shape, to rounding, unless it is fitted.
#pragma once

#include "meshing/curved_mesh.h"
#include "meshing/resolution.h"
#include "meshing/spherical_harmonics.h"

#include <functional>
#include <span>

namespace sbeh::meshing {

/// Radius in the direction of a unit vector.
using RadialFunction = std::function<double(const Eigen::Vector3d&)>;

/// x = r(d) d. Throws std::invalid_argument where r is not a positive finite number.
CurvedMesh star_shaped(const RadialFunction& r, const Resolution& resolution);

/// The unit sphere.
CurvedMesh sphere(const Resolution& resolution);

/// Semi-axes along x, y, z. Where it is too sharp for even triangles, they are those of a sphere stretched to it, slender
/// across its edge. Throws std::invalid_argument unless all are > 0 and within a factor of
/// 100 of each other.
CurvedMesh ellipsoid(const Eigen::Vector3d& semi_axes, const Resolution& resolution);

/// Spheroid about z, oblate or prolate, of area 4π and reduced volume 0 < V_r <= 1; the curved
/// mesh itself has these values to rounding, and its nodes, unless fitted, lie on one spheroid. At V_r = 1 it is
/// the sphere, whose mesh has a V_r a little below 1. Throws std::invalid_argument outside, for
/// shapes thinner than 1:100, and for V_r < 1 above that of this mesh of the sphere.
CurvedMesh ellipsoid(double reduced_volume, bool prolate, const Resolution& resolution);

/// r = 1 + Σ a_lm Y_lm. Throws std::invalid_argument where r <= 0.
CurvedMesh harmonic_sphere(std::span<const Harmonic> modes, const Resolution& resolution);

/// The same with all amplitudes multiplied by one factor > 0, so that the curved mesh has this
/// reduced volume to rounding. Throws std::invalid_argument unless 0 < V_r < 1, and where r would
/// reach 0 first.
CurvedMesh harmonic_sphere(std::span<const Harmonic> modes, double reduced_volume,
                           const Resolution& resolution);

}  // namespace sbeh::meshing
