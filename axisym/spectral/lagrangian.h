// The energy on a spectral curve, and its Lagrangian with exact first and second derivatives.
//
//   𝓛(y) = U(y) + Σ (A − 4π) − P (V − V₀) + χ ∫cos ψ dσ,   y = (ℓ, b, c): length, angle, order.
// Per σ, with r in units of ℓ and primes for d/dσ:
//   dU = 2πℓ² r e(β, β'²/ℓ², H, K),  H = −(ψ' + sin ψ/r)/ℓ,  K = ψ' sin ψ/(ℓ² r),
//   dA = 2πℓ² r,  dV = πℓ³ r² sin ψ,  e: model/energy_density.h.
// χ holds the curve closed; symmetric curves close by themselves.
#pragma once

#include "axisym/spectral/curve.h"
#include "model/energy_density.h"

#include <optional>

namespace sbeh::axisym::spectral {

/// Which functional of which unknowns. Without order β = 2/3 is no unknown.
struct Problem {
  model::Material material;
  std::shared_ptr<const Basis> basis;
  bool with_order = true;

  int unknowns() const { return 1 + basis->modes() + order_modes(); }
  int order_modes() const { return with_order ? int(basis->C.cols()) : 0; }
  int constraints() const { return basis->symmetry == Symmetry::none ? 3 : 2; }

  /// F/κ = ½∫H² dS of the shape alone.
  static Problem classical(std::shared_ptr<const Basis> basis);
};

/// Unknowns of a curve and the coefficients c of its order (empty without order), and back.
Eigen::VectorXd pack(const Curve& curve, const Eigen::VectorXd& c = {});
Curve curve_of(const Problem& problem, const Eigen::VectorXd& y);
Eigen::VectorXd order_of(const Problem& problem, const Eigen::VectorXd& y);

/// Σ, −P and χ: what multiplies area, volume and closure in the Lagrangian.
using Multipliers = Eigen::VectorXd;  // number of constraints

/// Value and first derivatives.
struct Expansion {
  double energy;
  Eigen::VectorXd gradient;  // of U
  Eigen::VectorXd measures;  // A, V, ∫cos ψ
  Eigen::MatrixXd jacobian;  // of the measures, one row each
};
/// Empty where the curve runs through the axis.
std::optional<Expansion> expand(const Problem& problem, const Eigen::VectorXd& y);
/// Second derivatives of 𝓛; only where `expand` is not empty.
Eigen::MatrixXd hessian(const Problem& problem, const Eigen::VectorXd& y,
                        const Multipliers& multipliers);

/// The energy by parts, for reports.
model::EnergyDensity<double> energy_parts(const Problem& problem, const Eigen::VectorXd& y);
/// H on the points, and at the first and the last pole.
Eigen::VectorXd mean_curvature(const Curve& curve);
Eigen::Vector2d pole_curvatures(const Curve& curve);

/// 4π, 4πV_r/3, 0: what the measures shall be.
Eigen::VectorXd target_of(const Problem& problem, double reduced_volume);
/// Multipliers which balance the gradient best.
Multipliers estimate_multipliers(const Expansion& at);

}  // namespace sbeh::axisym::spectral
