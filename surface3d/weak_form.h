// The weak form of one time step at a point of the surface, in the labels of model/equations.md.
//
// The unknowns of the flow are linear in it, so the same function gives residual (numbers) and matrix
// (automatic differentiation). What has p, λ or h, and the parts of the test functions along and across the
// node normals, are in element_system.cpp, (Y1) and (H1) in mesh_equation.h, the order equation in
// model/order_step.h.
#pragma once

#include "model/terms.h"
#include "surface3d/surface.h"

namespace sbeh::surface3d {

template <class T>
using CartesianGradient = Eigen::Matrix<T, 3, 2>;  // row: x, y, z; column: e1, e2

/// The unknowns of the flow at a point but for p: Cartesian components, d = gradient along (e1, e2).
template <class T>
struct Unknowns {
  model::Vector<T> V;  // velocity
  CartesianGradient<T> dV;
  T H;  // mean curvature of the next surface
  model::Tangent<T> dH;
};
inline constexpr std::size_t unknowns_size = 12;

/// The factors of the test functions and of their gradients: the equations are
/// ∫ W·test.W + dW:test.dW + dW_n:test.dW_n dS = 0, W_n the part of W along the node normals.
template <class T>
struct Tested {
  model::Vector<T> W;
  CartesianGradient<T> dW;
  CartesianGradient<T> dW_n;
};
inline constexpr std::size_t tested_size = 15;

/// What the coupled step reads of the old state at a point.
struct OldPoint {
  const SurfacePoint& geometry;
  double beta;
  model::Tangent<double> grad_beta;
  model::ShapeOperator<double> B;  ///< of the old surface, see shape_operator (curvature.h)
};

/// Momentum but for what has p, λ and h: (V1), (V2), and (V5)–(V11).
template <class T>
Tested<T> flow_point(const model::Material& m, const OldPoint& old, const Unknowns<T>& u) {
  const SurfacePoint& x = old.geometry;
  const Eigen::Vector3d nu = x.nu();

  const model::Gradient<T> grad_V = x.frame.transpose() * u.dV;
  const model::ElasticPoint<double, T> elastic{
      .beta = old.beta, .grad_beta = old.grad_beta, .B = old.B, .H = u.H, .grad_H = u.dH};

  model::Gradient<T> viscous = model::Gradient<T>::Zero();
  viscous.template topRows<2>() = model::rate_of_strain(grad_V) * m.eta(old.beta);  // (V1)
  const T V_n = u.V.dot(nu);
  model::Gradient<T> force = -model::elastic_stress(m, elastic);  // (V5) … (V10)
  const T e = model::energy_tension(m, elastic);                  // (V11)
  force(0, 0) += e;
  force(1, 1) += e;

  Tested<T> test;
  test.W =
      m.friction_tangential * u.V + (m.friction_normal - m.friction_tangential) * V_n * nu;  // (V2)
  test.dW = x.frame * viscous;
  test.dW_n = x.frame * force;
  return test;
}

}  // namespace sbeh::surface3d
