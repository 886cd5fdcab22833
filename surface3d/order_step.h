// The order equation (B1)–(B5) of one step, with the velocity and the mesh motion known.
#pragma once

#include "model/material.h"
#include "surface3d/curvature.h"

namespace sbeh::surface3d {

/// β of the next time, τ after `from`, which are the nodes' numbers; surface and coefficients are those
/// of `at`. 3 x nodes `slip` is that of the material, relative to the mesh: V − Y/τ. Empty
/// when the linear solve fails.
Field order_step(const Triangulation& mesh, const model::Material& material, const State& at,
                 const Field& from, const Curvature& curvature, const Nodes& slip, double tau);

/// h = δU/δβ, nodes: (h, ψ) = (B2) + … + (B5). Empty when the linear solve fails.
Field order_force(const Triangulation& mesh, const model::Material& material, const State& at,
                  const Curvature& curvature);

}  // namespace sbeh::surface3d
