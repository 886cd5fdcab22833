// The energy and the measures at a point of a spectral curve, per σ, with their first derivatives.
//
// With r in units of ℓ and primes for d/dσ:
//   dU = 2πℓ² r e(β, β'²/ℓ², H, K),  H = −(ψ' + sin ψ/r)/ℓ,  K = ψ' sin ψ/(ℓ² r),
//   dA = 2πℓ² r,  dV = πℓ³ r² sin ψ,  H dA = −2πℓ (rψ' + sin ψ),  e: model/energy_density.h.
#pragma once

#include "model/energy_density.h"
#include "model/terms.h"

#include <array>
#include <cmath>
#include <numbers>

namespace sbeh::axisym::spectral::point {

/// What the pointwise densities read, in this order everywhere.
enum Field { psi, dpsi, radius, order, dorder, length, fields };
template <class T>
using Point = std::array<T, fields>;

/// How many measures there are, in the order of Measure (lagrangian.h).
inline constexpr std::size_t measures = 5;

template <class T>
struct Curvatures {
  T H, K;
};
template <class T>
Curvatures<T> curvatures(const Point<T>& q) {
  using std::sin;
  const T turn = sin(q[psi]) / q[radius];
  return {.H = -(q[dpsi] + turn) / q[length], .K = q[dpsi] * turn / (q[length] * q[length])};
}

template <class T>
model::EnergyDensity<T> density(const model::Material& material, const Point<T>& q) {
  const T slope = q[dorder] / q[length];
  const auto [H, K] = curvatures(q);
  return model::energy_density(material, q[order], T(slope * slope), H, K);
}

/// dA
template <class T>
T area_density(const Point<T>& q) {
  return 2 * std::numbers::pi * q[length] * q[length] * q[radius];
}

/// ∂(dU) by the fields: the chain rule through H, K and |∇β|².
template <class T>
Point<T> energy_gradient(const model::Material& m, const Point<T>& q) {
  using std::cos, std::sin;
  const T &l = q[length], &r = q[radius], &beta = q[order];
  const T slope = q[dorder] / l, turn = sin(q[psi]) / r, turn_psi = cos(q[psi]) / r;
  const auto [H, K] = curvatures(q);
  const T e = density(m, q).total();
  const T e_H = m.moment(beta, H), e_K = m.kappa_gauss(beta);
  const T e_beta = model::order_force(m, beta, H, K);
  const T e_slope = m.l1() * slope;
  const T e_turn = -e_H / l + e_K * q[dpsi] / (l * l);
  const T dA = area_density(q);
  return {dA * e_turn * turn_psi,
          dA * (-e_H / l + e_K * turn / (l * l)),
          dA * (e / r - e_turn * turn / r),
          dA * e_beta,
          dA * e_slope / l,
          dA / l * (2. * e - e_slope * slope - e_H * H - 2. * e_K * K)};
}

/// β̄ of a material that conserves its order.
inline double mean_order(const model::Material& m) { return m.mean_order.value_or(0); }

/// The densities of all measures.
inline std::array<double, measures> measure_densities(const model::Material& m,
                                                      const Point<double>& q) {
  const double dA = area_density(q), rho = q[length] * q[radius];
  return {dA * m.packing(q[order]), std::numbers::pi * rho * rho * q[length] * std::sin(q[psi]),
          std::cos(q[psi]), dA * curvatures(q).H, dA * (q[order] - mean_order(m))};
}

/// ∂(these) by the fields.
template <class T>
std::array<Point<T>, measures> measure_gradients(const model::Material& m, const Point<T>& q) {
  using std::cos, std::sin;
  constexpr double pi = std::numbers::pi;
  const T &l = q[length], &r = q[radius], &beta = q[order];
  const T s = sin(q[psi]), c = cos(q[psi]), zero(0.);
  const T packed = m.packing(beta), excess = beta - mean_order(m), dA = area_density(q);
  return {{{zero, zero, 2 * pi * l * l * packed, dA * m.packing_slope(beta), zero,
            4 * pi * l * r * packed},
           {pi * l * l * l * r * r * c, zero, 2 * pi * l * l * l * r * s, zero, zero,
            3 * pi * l * l * r * r * s},
           {-s, zero, zero, zero, zero, zero},
           {-2 * pi * l * c, -2 * pi * l * r, -2 * pi * l * q[dpsi], zero, zero,
            -2 * pi * (r * q[dpsi] + s)},
           {zero, zero, 2 * pi * l * l * excess, dA, zero, 4 * pi * l * r * excess}}};
}

}  // namespace sbeh::axisym::spectral::point
