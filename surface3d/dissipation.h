// What a step dissipates.
#pragma once

#include "model/energy.h"
#include "surface3d/surface.h"

namespace sbeh::surface3d {

using model::Dissipation;

/// How a state changes, per time, on its nodes.
struct Motion {
  const Nodes& velocity;    // 3 x nodes, V
  const Nodes& slip;        // 3 x nodes, V − Y/τ, of the material relative to the mesh
  const Field& order_rate;  // nodes, at the moving nodes
  const Field& order;       // nodes, whose gradient the slip meets
};

/// Rates on the surface of `at`: friction (V2), of the order with β̇ = order_rate + slip·∇order, viscous (V1).
Dissipation dissipation_of(const Triangulation& mesh, const model::Material& material,
                           const State& at, const Motion& motion);

}  // namespace sbeh::surface3d
