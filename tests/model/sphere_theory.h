// What is known of a sphere with uniform order and of two modes near it.
//
// r = 1 + Σ u_l Y_l(θ), β = β₀ + Σ b_l Y_l, β₀ the rest state. To second order in the amplitudes the
// energy is that of the sphere and, with k = (l − 1)(l + 2),
//   ½ Σ { k κ [l(l + 1) + s] u_l² + 2 k C u_l b_l + [l₁ l(l + 1) + 2κ″ + κ_G″ + u″] b_l² },
// since δH = −k u_l, δK = k u_l and H = −2: C = (2 + H₀) κ' + κ_G'. The multiplier s(t) keeps the
// excess area ½ Σ k u_l²; the friction of mode l is ζ_l = γ_⊥ + 4γ_∥/l(l+1) + 4ηk/l(l+1): where every
// piece keeps its area, the tangential velocity of a normal velocity Y_l has Div_C w = −2 Y_l, so that
// ∫|w|² = 4/l(l+1) ∫Y_l². Where only the whole does, there is none: ζ_l = γ_⊥.
// With one constant C = 9Lβ₀ and 2κ″ + κ_G″ = 9L.
//
// The theory errs by O(ε) relative to an amplitude ε. Both modes with the opposite sign err by the
// opposite share, and the reflection of that run at the equator differs from the first in the sign of
// the even mode alone: the mean over both signs of u_2 errs by O(ε²). (A sign flip of the odd mode is
// that reflection itself, the same run.)
// The same holds for any longitudes: then the point reflection takes the place of that at the equator. With degrees 2 and 4, of which one
// alone changes its sign under a turn by 90°, the mean over both signs of the other errs by O(ε²) likewise.
#pragma once

#include "model/material.h"
#include "model/order_step.h"

#include <Eigen/Core>
#include <boost/numeric/odeint.hpp>
#include <ceres/jet.h>

#include <array>

namespace sbeh::model::test {

/// Uniform order on the unit sphere with one elastic constant: (3/2) M β̇ = −9Lβ − u'(β).
inline double order_on_sphere(const Material& m, double start, double time) {
  namespace odeint = boost::numeric::odeint;
  double beta = start;
  const auto rate = [&](const double& b, double& slope, double) {
    slope = -(9 * m.L1 * b + m.potential.slope(b)) / (1.5 * m.immobility);
  };
  odeint::integrate_adaptive(
      odeint::make_controlled<odeint::runge_kutta_dopri5<double>>(1e-13, 1e-13), rate, beta, 0.,
      time, 1e-3);
  return beta;
}

/// u_2, u_3, b_2, b_3; or of other degrees
using Amplitudes = std::array<double, 4>;

/// The rates of the amplitudes, for Boost.Odeint.
class TwoModes {
 public:
  TwoModes(const Material& m, Model model, const std::array<int, 2>& degrees = {2, 3})
      : degrees_(degrees),
        m_(effective(m, model)),
        model_(model),
        beta_(has_free_order(model) ? model::sphere_rest_order(m).value() : model::full_order) {}

  Model model() const { return model_; }
  double rest_order() const { return beta_; }
  double drag(int l) const {
    const double n = l * (l + 1);
    return m_.friction_normal + 4 * m_.friction_tangential / n + 4 * m_.eta(beta_) * (n - 2) / n;
  }
  // Long enough for u_2/u_3 to change noticeably.
  double end_time() const { return 0.015 * drag(3) / m_.kappa(beta_); }

  void operator()(const Amplitudes& x, Amplitudes& rate, double) const {
    const double kappa = m_.kappa(beta_);
    const double coupling =
        (2 + m_.spontaneous_curvature) * m_.kappa_slope(beta_) + m_.kappa_gauss_slope(beta_);
    double with = 0, without = 0;  // Σ k u u̇ = without + s · with
    std::array<double, 2> force{};
    for (const std::size_t i : {0, 1}) {
      const int l = degrees_[i];
      const double n = l * (l + 1), k = n - 2, u = x[i];
      force[i] = kappa * n * u + (has_free_order(model_) ? coupling * x[i + 2] : 0);
      without -= k * u * k * force[i] / drag(l);
      with -= k * u * k * kappa * u / drag(l);
    }
    const double s = -without / with;
    for (const std::size_t i : {0, 1}) {
      const int l = degrees_[i];
      const double n = l * (l + 1), k = n - 2;
      rate[i] = -k * (force[i] + kappa * s * x[i]) / drag(l);
      rate[i + 2] = has_free_order(model_)
                      ? -((m_.l1() * n + order_stiffness()) * x[i + 2] + coupling * k * x[i])
                            / m_.order_drag()
                      : 0;
    }
  }

 private:
  std::array<int, 2> degrees_;
  double order_stiffness() const {
    return 2 * m_.kappa_slope(1.) + m_.kappa_gauss_slope(1.)
         + m_.potential.slope(ceres::Jet<double, 1>(beta_, 0)).v[0];
  }
  Material m_;
  Model model_;
  double beta_;
};

/// u_2/u_3 at equal shares of the time of `modes`.
inline Eigen::ArrayXd two_mode_ratios(const TwoModes& modes, Amplitudes x, int outputs) {
  namespace odeint = boost::numeric::odeint;
  const double dt = modes.end_time() / outputs;
  Eigen::ArrayXd q(outputs);
  for (int k = 0; k < outputs; ++k) {
    odeint::integrate_adaptive(
        odeint::make_controlled<odeint::runge_kutta_dopri5<Amplitudes>>(1e-13, 1e-10), modes, x,
        k * dt, (k + 1) * dt, dt / 10);
    q[k] = x[0] / x[1];
  }
  return q;
}

}  // namespace sbeh::model::test
