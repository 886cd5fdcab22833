// The weak form of one time step at a point of the curve, in the labels of model/equations.md.
//
// The unknowns of the coupled step are linear in it, so the same function gives residual (numbers)
// and matrix (automatic differentiation).
#pragma once

#include "axisym/curve.h"
#include "model/mesh_motion.h"
#include "model/terms.h"

#include <array>

namespace sbeh::axisym {

/// The unknowns of the coupled step at a point: (r, z) components, d = derivative by the element's
/// coordinate.
template <class T>
struct Unknowns {
  Eigen::Matrix<T, 2, 1> V, dV;  // velocity
  T p;                           // surface pressure, over n/n(2/3)
  T H, dH;                       // mean curvature of the next surface
  Eigen::Matrix<T, 2, 1> Y, dY;  // displacement of the mesh
};
inline constexpr std::size_t unknowns_size = 11;

/// The factors of the test functions and of their derivatives: the equations are
/// ∫ W·test.W + dW·test.dW + q test.q + … dS = 0.
template <class T>
struct Tested {
  Eigen::Matrix<T, 2, 1> W, dW;  // momentum
  T q;                           // area
  T G;                           // normal motion of the mesh
  Eigen::Matrix<T, 2, 1> Z, dZ;  // curvature
};
inline constexpr std::size_t tested_size = 10;

/// What the coupled step reads of the old state at a point.
struct OldPoint {
  CurvePoint geometry;
  double beta, beta_s;  ///< order and its derivative by arc length
  double H;             ///< discrete mean curvature of the old surface
};

/// Choices of the step which every point sees.
struct StepParameters {
  double tau;  ///< time step
  double
      area_rate;  ///< (A₀ − A)/(τA), the drift correction of (P1); A₀ and A in its numerator are lipid_area
  model::AreaConstraint area_constraint = model::AreaConstraint::local;  ///< global: with (V11)
};

/// ∇_C W in the frame (t, e_φ, ν) of a field W with values W and derivative dW.
template <class T>
model::Gradient<T> surface_gradient(const CurvePoint& x, const Eigen::Matrix<T, 2, 1>& W,
                                    const Eigen::Matrix<T, 2, 1>& dW) {
  model::Gradient<T> grad = model::Gradient<T>::Zero();
  grad(0, 0) = (dW[0] * x.t[0] + dW[1] * x.t[1]) / x.stretch;
  grad(1, 1) = W[0] / x.x[0];
  grad(2, 0) = (dW[0] * x.nu[0] + dW[1] * x.nu[1]) / x.stretch;
  return grad;
}

/// Adds (S, ∇_C W) to the factors of W and dW: the transpose of surface_gradient.
template <class T>
void test_with_gradient(const CurvePoint& x, const model::Gradient<T>& S, Eigen::Matrix<T, 2, 1>& W,
                        Eigen::Matrix<T, 2, 1>& dW) {
  for (int k = 0; k < 2; ++k) dW[k] += (S(0, 0) * x.t[k] + S(2, 0) * x.nu[k]) / x.stretch;
  W[0] += S(1, 1) / x.x[0];
}

/// The shape operator diag(H − B_φφ, B_φφ) of a curve whose mean curvature is known.
inline model::ShapeOperator<double> shape_operator(double H, double B_phi) {
  model::ShapeOperator<double> B;
  B << H - B_phi, 0, 0, B_phi;
  return B;
}

/// (V13): the force of a unit moment of the area difference.
struct MomentForce {
  Eigen::Vector2d W, dW;
};
inline MomentForce moment_point(const OldPoint& old) {
  MomentForce test{Eigen::Vector2d::Zero(), Eigen::Vector2d::Zero()};
  const auto stress = model::moment_stress(shape_operator(old.H, old.geometry.B_phi));  // (V13)
  test_with_gradient(old.geometry, stress, test.W, test.dW);
  return test;
}

/// Momentum (V1)–(V11) without (V4), incompressibility (P1), normal motion (Y1) and curvature (H1).
template <class T>
Tested<T> coupled_step_point(const model::Material& m, const OldPoint& old,
                             const StepParameters& step, const Unknowns<T>& u) {
  using Vector2 = Eigen::Matrix<T, 2, 1>;
  const CurvePoint& x = old.geometry;
  const auto dot = [](const Vector2& a, const Eigen::Vector2d& b) -> T {
    return a[0] * b[0] + a[1] * b[1];
  };

  const model::Gradient<T> grad_V = surface_gradient(x, u.V, u.dV);
  const model::ElasticPoint<double, T> elastic{
      .beta = old.beta,
      .grad_beta = {old.beta_s, 0},
      .B = shape_operator(old.H, x.B_phi),
      .H = u.H,
      .grad_H = {u.dH / x.stretch, T(0)},
  };

  model::Gradient<T> stress = -model::elastic_stress(m, elastic);  // (V5) … (V10)
  stress.template topRows<2>() += model::rate_of_strain(grad_V) * T(m.eta(old.beta));  // (V1)
  const double packing = m.packing(old.beta);
  T isotropic = -packing * u.p;  // (V3)
  if (step.area_constraint == model::AreaConstraint::global)
    isotropic += model::bending_tension(m, elastic);  // (V11)
  else if (m.has_lipid_density())
    isotropic += model::energy_tension(m, elastic);  // (V11)
  stress(0, 0) += isotropic;
  stress(1, 1) += isotropic;

  const T V_t = dot(u.V, x.t) * m.friction_tangential;  // (V2)
  const T V_n = dot(u.V, x.nu);
  const T friction_n = V_n * m.friction_normal;

  Tested<T> test;
  for (int k = 0; k < 2; ++k) {
    test.W[k] = V_t * x.t[k] + friction_n * x.nu[k];
    test.dW[k] = T(0);
  }
  test_with_gradient(x, stress, test.W, test.dW);

  test.q = packing * model::divergence(grad_V) - step.area_rate;  // (P1)
  test.G = dot(u.Y, x.nu) - step.tau * V_n;                       // (Y1)
  const double theta = model::mesh_share(step.tau);
  for (int k = 0; k < 2; ++k) {  // (H1)
    test.Z[k] = (u.H - (1 - theta) * old.H) * x.nu[k];
    test.dZ[k] = (u.dY[k] + theta * x.dx[k]) / (x.stretch * x.stretch);
  }
  test.Z[0] += (u.Y[0] + theta * x.x[0]) / (x.x[0] * x.x[0]);
  return test;
}

}  // namespace sbeh::axisym
