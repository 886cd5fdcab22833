// The weak form of one time step at a point of the surface, in the labels of model/equations.md.
//
// The unknowns of the flow are linear in it, so the same functions give residual (numbers) and matrix
// (automatic differentiation). What has p, λ or h, and the parts of the test functions along and across the
// node normals, are in element_system.cpp, (Y1) and (H1) in mesh_equation.h, the order equation in
// model/order_step.h.
#pragma once

#include "model/terms.h"
#include "surface3d/surface.h"

namespace sbeh::surface3d {

template <class T>
using CartesianGradient = Eigen::Matrix<T, 3, 2>;  // row: x, y, z; column: e1, e2

/// Velocity at a point: Cartesian components, d = gradient along (e1, e2).
template <class T>
struct Velocity {
  model::Vector<T> V;
  CartesianGradient<T> dV;
};
/// Mean curvature of the next surface at a point.
template <class T>
struct NextCurvature {
  T H;
  model::Tangent<T> dH;
};

/// The factors of the test functions W and of their gradients: ∫ W·test.W + dW:test.dW dS.
template <class T>
struct Tested {
  model::Vector<T> W;
  CartesianGradient<T> dW;
};

/// What the coupled step reads of the old state at a point.
struct OldPoint {
  const SurfacePoint& geometry;
  double beta;
  model::Tangent<double> grad_beta;
  model::ShapeOperator<double> B;  ///< of the old surface, see shape_operator (curvature.h)
};

/// What resists the flow, tested with W: (V1), (V2).
template <class T>
Tested<T> resistance_at(const model::Material& m, const OldPoint& old, const Velocity<T>& u) {
  const SurfacePoint& x = old.geometry;
  const Eigen::Vector3d nu = x.nu();
  const model::Gradient<T> grad_V = x.frame.transpose() * u.dV;
  model::Gradient<T> viscous = model::Gradient<T>::Zero();
  viscous.template topRows<2>() = model::rate_of_strain(grad_V) * m.eta(old.beta);  // (V1)
  const T V_n = u.V.dot(nu);
  return {
      m.friction_tangential * u.V + (m.friction_normal - m.friction_tangential) * V_n * nu,  // (V2)
      x.frame * viscous};
}

/// The elastic forces, tested with the gradient of W_n, the part of W along the node normals: (V5)–(V11).
template <class T>
CartesianGradient<T> elastic_force_at(const model::Material& m, const OldPoint& old,
                                      const NextCurvature<T>& u) {
  const model::ElasticPoint<double, T> elastic{
      .beta = old.beta, .grad_beta = old.grad_beta, .B = old.B, .H = u.H, .grad_H = u.dH};
  model::Gradient<T> force = -model::elastic_stress(m, elastic);  // (V5) … (V10)
  const T e = model::energy_tension(m, elastic);                  // (V11)
  force(0, 0) += e;
  force(1, 1) += e;
  return old.geometry.frame * force;
}

}  // namespace sbeh::surface3d
