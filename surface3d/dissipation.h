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

/// β̇ = order_rate + slip·∇order of a triangle's material.
class OrderRate {
 public:
  OrderRate(const Triangulation& mesh, const Motion& motion, int e)
      : slips_(on_element(mesh, e, motion.slip)),
        rates_(on_element(mesh, e, motion.order_rate)),
        order_(on_element(mesh, e, motion.order)) {}
  double at(const ShapeValues& s, const SurfacePoint& p) const {
    const Eigen::Vector2d slip_t = p.frame.leftCols<2>().transpose() * value_at(slips_, s);
    return value_at(rates_, s) + slip_t.dot(gradient_at(order_, p));
  }

 private:
  ElementNodes slips_;
  ElementField rates_, order_;
};

/// Rates on the surface of `at`: friction (V2), of the order with β̇ = order_rate + slip·∇order, viscous (V1).
Dissipation dissipation_of(const Triangulation& mesh, const model::Material& material,
                           const State& at, const Motion& motion);

}  // namespace sbeh::surface3d
