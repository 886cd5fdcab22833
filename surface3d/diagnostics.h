// What is measured on a state: energy and its parts, geometry, order.
#pragma once

#include "model/domains.h"
#include "model/energy.h"
#include "model/material.h"
#include "surface3d/curvature.h"

namespace sbeh::surface3d {

using model::Energy;

/// Energy of a state whose curvature is known. Its Gaussian part is that of rest states: where κ_G is constant nothing but
/// 4π κ_G, whatever the triangles (gaussian_energy.h).
Energy energy(const Triangulation& mesh, const model::Material& material, const State& state,
              const Curvature& curvature);

/// The same with the determinant of the shape operator for the Gaussian curvature, whose integral is 4π but for the error of the elements.
Energy energy_by_shape_operator(const Triangulation& mesh, const model::Material& material,
                                const State& state, const Curvature& curvature);

/// Smallest over all triangles and their nodes of J_min/J_max · 4√3 area/Σ(side)², 1 for flat
/// equilateral triangles, <= 0 where one is turned over; J the area per reference area, sides and area
/// those of the corners.
double mesh_quality(const Triangulation& mesh, const Nodes& X);

/// A mesh of lower quality is degenerate.
inline constexpr double degenerate_quality = 0.02;

/// Integrated and extreme values of a state; lengths in radii of the sphere of equal area.
struct Diagnostics {
  Energy energy;
  double area, volume, reduced_volume;
  double W2;                     ///< ∫ H dS, −8π on the unit sphere
  double total_gauss_curvature;  ///< ∫ K dS: 4π but for the error of B
  double order_min, order_mean, order_max;
  double order_variance;  ///< (1/A)∫(β − mean)² dS
  double order_std;       ///< its root
  model::Domains domains;
  double H_abs_max;     ///< largest |H|
  double resolution;    ///< largest |B| times the node spacing, as the area there tells it
  double mesh_quality;  ///< see mesh_quality
  double asymmetry;     ///< see symmetry.h, of a state whose mesh has a symmetry; else not a number
};
/// Throws std::runtime_error where the surface is degenerate.
Diagnostics diagnose(const Triangulation& mesh, const model::Material& material,
                     const State& state);

}  // namespace sbeh::surface3d
