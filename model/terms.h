// The pointwise terms of the weak form, one function per label of equations.md.
//
// Tensors stand in an orthonormal frame (e1, e2, ν) at the point, ν the outward normal:
//   tangent vector     2      (e1, e2)
//   vector             3      (e1, e2, ν)
//   shape operator B   2 x 2  symmetric, B = −∇_C ν, −I on the unit sphere
//   gradient, stress   3 x 2  row: component (e1, e2, ν), column: direction (e1, e2)
// A stress T enters the momentum equation as (T, ∇_C W).
#pragma once

#include "model/material.h"

#include <Eigen/Core>

#include <array>

namespace sbeh::model {

template <class T>
using Tangent = Eigen::Matrix<T, 2, 1>;
template <class T>
using Vector = Eigen::Matrix<T, 3, 1>;
template <class T>
using ShapeOperator = Eigen::Matrix<T, 2, 2>;
template <class T>
using Gradient = Eigen::Matrix<T, 3, 2>;

/// What the elastic terms read at a point. S: number type of order and B, T: of H and ∇H
/// (a time step knows the former and solves for the latter).
template <class S, class T>
struct ElasticPoint {
  S beta;
  Tangent<S> grad_beta;
  ShapeOperator<S> B;
  T H;
  Tangent<T> grad_H;
};

namespace detail {
// ν ⊗ g: a tangent vector in the normal row.
template <class T>
Gradient<T> normal_row(const Tangent<T>& g) {
  Gradient<T> stress = Gradient<T>::Zero();
  stress.row(2) = g.transpose();
  return stress;
}
// a tangential tensor in the tangential rows.
template <class T>
Gradient<T> tangential_rows(const Eigen::Matrix<T, 2, 2>& tensor) {
  Gradient<T> stress = Gradient<T>::Zero();
  stress.template topRows<2>() = tensor;
  return stress;
}
}  // namespace detail

/// (V5) l₁ ∇β ⊗ ∇β
template <class S, class T>
Gradient<T> distortion_stress(const Material& m, const ElasticPoint<S, T>& x) {
  const Eigen::Matrix<S, 2, 2> tensor = S(m.l1()) * (x.grad_beta * x.grad_beta.transpose());
  return detail::tangential_rows<T>(tensor.template cast<T>());
}

/// (V6) [κ (H − H₀) + f] B
template <class S, class T>
Gradient<T> bending_stress(const Material& m, const ElasticPoint<S, T>& x) {
  const T factor = m.moment(x.beta, x.H);
  return detail::tangential_rows<T>(x.B.template cast<T>() * factor);
}

/// (V7) ν ⊗ κ ∇H
template <class S, class T>
Gradient<T> curvature_gradient_stress(const Material& m, const ElasticPoint<S, T>& x) {
  return detail::normal_row<T>(T(m.kappa(x.beta)) * x.grad_H);
}

/// (V8) ν ⊗ [(H − H₀) ∇κ + ∇f]
template <class S, class T>
Gradient<T> stiffness_gradient_stress(const Material& m, const ElasticPoint<S, T>& x) {
  const T factor = m.moment_slope(x.beta, x.H);
  return detail::normal_row<T>(x.grad_beta.template cast<T>() * factor);
}

/// (V9) ν ⊗ H ∇κ_G
template <class S, class T>
Gradient<T> gaussian_trace_stress(const Material& m, const ElasticPoint<S, T>& x) {
  const T factor = m.kappa_gauss_slope(x.beta) * x.H;
  return detail::normal_row<T>(x.grad_beta.template cast<T>() * factor);
}

/// (V10) −ν ⊗ B ∇κ_G
template <class S, class T>
Gradient<T> gaussian_shape_stress(const Material& m, const ElasticPoint<S, T>& x) {
  const Tangent<S> g = -m.kappa_gauss_slope(x.beta) * (x.B * x.grad_beta);
  return detail::normal_row<T>(g.template cast<T>());
}

/// (V11) of (E2), (E5): (κ/2)(tr B − H₀)(H − H₀) + f H, isotropic. For β ≡ 2/3 it is all that varies of e.
template <class S, class T>
T bending_tension(const Material& m, const ElasticPoint<S, T>& x) {
  const S known = m.kappa(x.beta) / 2. * (x.B.trace() - m.spontaneous_curvature);
  return T(known) * (x.H - m.spontaneous_curvature) + T(m.flexoelectric.value(x.beta)) * x.H;
}

/// (V11) e = (E1) + (E2) + (E4) + (E5), isotropic: −(e, Div_C W) stands in the momentum equation where the pressure
/// does not take it up. (E2) in the form that is linear in H.
template <class S, class T>
T energy_tension(const Material& m, const ElasticPoint<S, T>& x) {
  return bending_tension(m, x)
       + T(m.l1() / 2. * x.grad_beta.squaredNorm() + m.potential.value(x.beta));
}

/// (V13) H P − B, of which (…, ∇_C W) is ∂W₂: what a unit moment of (E6) makes, of the sign of what resists.
template <class S>
Gradient<S> moment_stress(const ShapeOperator<S>& B) {
  const Eigen::Matrix<S, 2, 2> tensor = B.trace() * Eigen::Matrix<S, 2, 2>::Identity() - B;
  return detail::tangential_rows<S>(tensor);  // (V13)
}

/// (V12) h ∇β, h = δU/δβ: what the elastic forces are along the surface, but for gradients.
template <class T>
Tangent<T> order_traction(const T& h, const Tangent<T>& grad_beta) {
  return h * grad_beta;  // (V12)
}

/// The right-hand side of the momentum equation: the sum of (V5) … (V10).
template <class S, class T>
Gradient<T> elastic_stress(const Material& m, const ElasticPoint<S, T>& x) {
  return distortion_stress(m, x)          // (V5)
       + bending_stress(m, x)             // (V6)
       + curvature_gradient_stress(m, x)  // (V7)
       + stiffness_gradient_stress(m, x)  // (V8)
       + gaussian_trace_stress(m, x)      // (V9)
       + gaussian_shape_stress(m, x);     // (V10)
}

/// σ(V) = P∇_C V + (P∇_C V)ᵀ, tangential on both sides; 2 x 2. (V1) is η(β) σ(V).
template <class T>
Eigen::Matrix<T, 2, 2> rate_of_strain(const Gradient<T>& grad_V) {
  return grad_V.template topRows<2>() + grad_V.template topRows<2>().transpose();
}

/// Div_C V = tr ∇_C V.
template <class T>
T divergence(const Gradient<T>& grad_V) {
  return grad_V(0, 0) + grad_V(1, 1);
}

/// K = (H² − |B|²)/2 of a symmetric B: its determinant.
template <class S>
S gauss_curvature(const ShapeOperator<S>& B) {
  return B(0, 0) * B(1, 1) - B(0, 1) * B(1, 0);
}

/// (B3) (κ'/2)(H − H₀)², linear in β.
template <class T>
T bending_force(const Material& m, const T& beta, const T& H) {
  const T excess = H - m.spontaneous_curvature;
  return m.kappa_slope(beta) / 2. * excess * excess;
}

/// (B6) f' H
template <class T>
T flexoelectric_force(const Material& m, const T& beta, const T& H) {
  return m.flexoelectric.slope(beta) * H;
}

/// (B4) κ_G' K, linear in β.
template <class T>
T gaussian_force(const Material& m, const T& beta, const T& K) {
  return m.kappa_gauss_slope(beta) * K;
}

/// ∂(energy density)/∂β.
template <class T>
T order_force(const Material& m, const T& beta, const T& H, const T& K) {
  return bending_force(m, beta, H)        // (B3)
       + gaussian_force(m, beta, K)       // (B4)
       + flexoelectric_force(m, beta, H)  // (B6)
       + m.potential.slope(beta);         // (B5) u'
}

}  // namespace sbeh::model
