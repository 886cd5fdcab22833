// What is measured on a state: energy and its parts, geometry, order.
#pragma once

#include "model/energy.h"
#include "model/material.h"
#include "surface3d/curvature.h"

namespace sbeh::surface3d {

using model::Energy;

/// Energy of a state whose curvature is known.
Energy energy(const Triangulation& mesh, const model::Material& material, const State& state,
              const Curvature& curvature);

/// Smallest over all triangles and their nodes of J_min/J_max · 4√3 area/Σ(side)², 1 for flat
/// equilateral triangles, <= 0 where one is turned over; J the area per reference area, sides and area
/// those of the corners.
double mesh_quality(const Triangulation& mesh, const Nodes& X);

/// A mesh of lower quality is degenerate.
inline constexpr double degenerate_quality = 0.02;

struct Diagnostics : model::Diagnostics {
  double total_gauss_curvature;  ///< ∫ K dS: 4π but for the error of B
  double resolution;             ///< largest |B| times the node spacing
};
/// Throws std::runtime_error where the surface is degenerate.
Diagnostics diagnose(const Triangulation& mesh, const model::Material& material,
                     const State& state);

}  // namespace sbeh::surface3d
