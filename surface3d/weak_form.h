// The weak form of one time step at a point of the surface, in the labels of model/equations.md.
//
// The unknowns of the flow are linear in it, so the same function gives residual (numbers) and matrix
// (automatic differentiation). (V4) and (P2) are in coupled_system.cpp, (Y1) and (H1) in mesh_equation.h,
// the order equation in model/order_step.h.
#pragma once

#include "model/terms.h"
#include "surface3d/surface.h"

namespace sbeh::surface3d {

template <class T>
using CartesianGradient = Eigen::Matrix<T, 3, 2>;  // row: x, y, z; column: e1, e2

/// The unknowns of the flow at a point: Cartesian components, d = gradient along (e1, e2).
template <class T>
struct Unknowns {
  model::Vector<T> V;  // velocity
  CartesianGradient<T> dV;
  T p;  // surface pressure
  T H;  // mean curvature of the next surface
  model::Tangent<T> dH;
};
inline constexpr std::size_t unknowns_size = 13;

/// The factors of the test functions and of their gradients: the equations are
/// ∫ W·test.W + dW:test.dW + q test.q dS = 0.
template <class T>
struct Tested {
  model::Vector<T> W;  // momentum
  CartesianGradient<T> dW;
  T q;  // area
};
inline constexpr std::size_t tested_size = 10;

/// What the coupled step reads of the old state at a point.
struct OldPoint {
  const SurfacePoint& geometry;
  double beta;
  model::Tangent<double> grad_beta;
  model::ShapeOperator<double> B;  ///< of the old surface, see shape_operator (curvature.h)
};

/// Choices of the step which every point sees.
struct StepParameters {
  double area_rate;  ///< (A₀ − A)/(τA), the drift correction of (P1)
  model::AreaConstraint area_constraint = model::AreaConstraint::local;  ///< global: with (V11)
};

/// Momentum (V1)–(V11) without (V4), and incompressibility (P1).
template <class T>
Tested<T> flow_point(const model::Material& m, const OldPoint& old, const StepParameters& step,
                     const Unknowns<T>& u) {
  const SurfacePoint& x = old.geometry;
  const Eigen::Vector3d nu = x.nu();

  const model::Gradient<T> grad_V = x.frame.transpose() * u.dV;
  const model::ElasticPoint<double, T> elastic{
      .beta = old.beta, .grad_beta = old.grad_beta, .B = old.B, .H = u.H, .grad_H = u.dH};

  model::Gradient<T> stress = -model::elastic_stress(m, elastic);  // (V5) … (V10)
  stress.template topRows<2>() += model::rate_of_strain(grad_V) * m.eta(old.beta);  // (V1)
  T isotropic = -u.p;                                                               // (V3)
  if (step.area_constraint == model::AreaConstraint::global)
    isotropic += model::bending_tension(m, elastic);  // (V11)
  stress(0, 0) += isotropic;
  stress(1, 1) += isotropic;

  const T V_n = u.V.dot(nu);

  Tested<T> test;
  test.W =
      m.friction_tangential * u.V + (m.friction_normal - m.friction_tangential) * V_n * nu;  // (V2)
  test.dW = x.frame * stress;
  test.q = model::divergence(grad_V) - step.area_rate;  // (P1)
  return test;
}

}  // namespace sbeh::surface3d
