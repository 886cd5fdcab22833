// The Gaussian energy of a surface of curved triangles, for which Gauss and Bonnet's theorem holds exactly: gaussian_density.h.
#pragma once

#include "model/material.h"
#include "surface3d/surface.h"

namespace sbeh::surface3d {

/// ∫ κ_G(β) K; 4π κ_G of a uniform order, whatever the triangles.
double gaussian_energy(const model::Material& material, const Triangulation& mesh,
                       const State& state);

/// 2π − (π/3) valence: the curvature of a corner where all angles are π/3; 0 at all other nodes.
Field corner_curvatures(const Triangulation& mesh);

}  // namespace sbeh::surface3d
