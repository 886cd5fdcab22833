// The weak form of one time step at a point of the surface, in the labels of model/equations.md.
//
// The unknowns of the coupled step are linear in it, so the same function gives residual (numbers)
// and matrix (automatic differentiation).
#pragma once

#include "model/terms.h"
#include "surface3d/surface.h"

namespace sbeh::surface3d {

template <class T>
using CartesianGradient = Eigen::Matrix<T, 3, 2>;  // row: x, y, z; column: e1, e2

/// Fields of the coupled step at a point: Cartesian components, gradients along (e1, e2). For the
/// unknowns these are values; for the result of `coupled_step_point` they are the factors of the test
/// functions W (for V), q (p), G (H) and Z (Y).
template <class T>
struct CoupledData {
  model::Vector<T> V;  // velocity
  CartesianGradient<T> dV;
  T p;  // surface pressure
  T H;  // mean curvature of the next surface
  model::Tangent<T> dH;
  model::Vector<T> Y;  // displacement of the mesh
  CartesianGradient<T> dY;
};
inline constexpr std::size_t coupled_data_size = 22;

/// What the coupled step reads of the old state at a point.
struct OldPoint {
  const SurfacePoint& geometry;
  double beta;
  model::Tangent<double> grad_beta;
  model::ShapeOperator<double> B;  ///< of the old surface, see shape_operator (curvature.h)
  CartesianGradient<double>
      grad_from;  ///< ∇_C of the positions from which Y counts: P for the old ones
};

/// Choices of the step which every point sees.
struct StepParameters {
  double tau;        ///< time step
  double area_rate;  ///< (A₀ − A)/(τA), the drift correction of (P1)
  model::AreaConstraint area = model::AreaConstraint::local;  ///< global: with (V11)
};

/// Momentum (V1)–(V11) without (V4), incompressibility (P1), normal motion (Y1) and curvature (H1).
template <class T>
CoupledData<T> coupled_step_point(const model::Material& m, const OldPoint& old,
                                  const StepParameters& step, const CoupledData<T>& u) {
  const SurfacePoint& x = old.geometry;
  const Eigen::Vector3d nu = x.nu();

  const model::Gradient<T> grad_V = x.frame.transpose() * u.dV;
  const model::ElasticPoint<double, T> elastic{
      .beta = old.beta, .grad_beta = old.grad_beta, .B = old.B, .H = u.H, .grad_H = u.dH};

  model::Gradient<T> stress = -model::elastic_stress(m, elastic);  // (V5) … (V10)
  stress.template topRows<2>() += model::rate_of_strain(grad_V) * m.eta(old.beta);  // (V1)
  T isotropic = -u.p;                                                                  // (V3)
  if (step.area == model::AreaConstraint::global)
    isotropic += model::bending_tension(m, elastic);  // (V11)
  stress(0, 0) += isotropic;
  stress(1, 1) += isotropic;

  const T V_n = u.V.dot(nu);

  CoupledData<T> g;
  g.V = m.friction_tangential * u.V
      + (m.friction_normal - m.friction_tangential) * V_n * nu;  // (V2)
  g.dV = x.frame * stress;
  g.p = model::divergence(grad_V) - step.area_rate;  // (P1)
  g.H = u.Y.dot(nu) - step.tau * V_n;                // (Y1)
  g.dH.setZero();
  g.Y = u.H * nu;  // (H1)
  g.dY = u.dY + old.grad_from.cast<T>();
  return g;
}

}  // namespace sbeh::surface3d
