// The order equation (B1)–(B5) of one step, with the velocity and the mesh motion known.
#pragma once

#include "model/material.h"
#include "surface3d/curvature.h"

namespace sbeh::surface3d {

/// β of the next time: 3 x nodes `slip` is the velocity of the material relative to the mesh, V − Y/τ,
/// on the old surface. Empty when the linear solve fails.
Field order_step(const Triangulation& mesh, const model::Material& material, const State& old,
                 const Curvature& curvature, const Nodes& slip, double tau);

}  // namespace sbeh::surface3d
