// The weak form of one time step at a point of the surface, in the labels of model/equations.md.
//
// The unknowns of the flow are linear in it, so the same function gives residual (numbers) and matrix
// (automatic differentiation). (Y1) and (H1) are made of a few matrices, see MeshMatrices.
#pragma once

#include "model/terms.h"
#include "surface3d/surface.h"

namespace sbeh::surface3d {

template <class T>
using CartesianGradient = Eigen::Matrix<T, 3, 2>;  // row: x, y, z; column: e1, e2

/// Fields of the flow at a point: Cartesian components, gradients along (e1, e2). For the unknowns these
/// are values; for the result of `flow_point` they are the factors of the test functions W (for V) and
/// q (p); those of H are zero.
template <class T>
struct FlowData {
  model::Vector<T> V;  // velocity
  CartesianGradient<T> dV;
  T p;  // surface pressure
  T H;  // mean curvature of the next surface
  model::Tangent<T> dH;
};
inline constexpr std::size_t flow_data_size = 13;

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
  model::AreaConstraint area = model::AreaConstraint::local;  ///< global: with (V11)
};

/// Momentum (V1)–(V11) without (V4), and incompressibility (P1).
template <class T>
FlowData<T> flow_point(const model::Material& m, const OldPoint& old, const StepParameters& step,
                       const FlowData<T>& u) {
  const SurfacePoint& x = old.geometry;
  const Eigen::Vector3d nu = x.nu();

  const model::Gradient<T> grad_V = x.frame.transpose() * u.dV;
  const model::ElasticPoint<double, T> elastic{
      .beta = old.beta, .grad_beta = old.grad_beta, .B = old.B, .H = u.H, .grad_H = u.dH};

  model::Gradient<T> stress = -model::elastic_stress(m, elastic);  // (V5) … (V10)
  stress.template topRows<2>() += model::rate_of_strain(grad_V) * m.eta(old.beta);  // (V1)
  T isotropic = -u.p;                                                               // (V3)
  if (step.area == model::AreaConstraint::global)
    isotropic += model::bending_tension(m, elastic);  // (V11)
  stress(0, 0) += isotropic;
  stress(1, 1) += isotropic;

  const T V_n = u.V.dot(nu);

  FlowData<T> g;
  g.V =
      m.friction_tangential * u.V + (m.friction_normal - m.friction_tangential) * V_n * nu;  // (V2)
  g.dV = x.frame * stress;
  g.p = model::divergence(grad_V) - step.area_rate;  // (P1)
  g.H = T(0);
  g.dH.setZero();
  return g;
}

}  // namespace sbeh::surface3d
