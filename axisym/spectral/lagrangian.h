// The energy on a spectral curve, and its Lagrangian with exact first and second derivatives.
//
//   𝓛(y) = U(y) + Σ (A − 4π) − P (V − V₀) + χ ∫cos ψ dσ [+ c (W₂ − W₂⁰)] [− μ_β ∫(β − β̄) dS],
//   y = (ℓ, b, c): length, angle, order;  U = ∫e dS + (k_ad π/(2A)) (W₂ − W₂⁰)²,
// with the densities of point_density.h. A is the area of the lipids at full order where the material has lipid_density.
// χ holds the curve closed; symmetric curves close by themselves. W₂ is held where k_ad is infinite, ∫(β − β̄) dS where
// the order is conserved.
#pragma once

#include "axisym/spectral/curve.h"
#include "model/energy_density.h"

#include <optional>
#include <utility>
#include <vector>

namespace sbeh::axisym::spectral {

/// What can be held: area, volume, closure, W₂ = ∫H dS, ∫(β − β̄) dS.
enum class Measure { area, volume, closure, W2, excess_order };

/// Which functional of which unknowns. Without order β = 2/3 is no unknown.
struct Problem {
  model::Material material;
  std::shared_ptr<const Basis> basis;
  bool with_order = true;

  int unknowns() const { return 1 + basis->modes() + order_modes(); }
  int order_modes() const { return with_order ? int(basis->C.cols()) : 0; }
  /// What is held, in the order of the multipliers.
  std::vector<Measure> held() const;
  int constraints() const { return int(held().size()); }
  /// Where `measure` stands among them; −1 where it is not held.
  int place_of(Measure measure) const;
  Problem on(std::shared_ptr<const Basis> other) const {
    return {material, std::move(other), with_order};
  }

  /// F/κ = ½∫H² dS of the shape alone.
  static Problem classical(std::shared_ptr<const Basis> basis);
  /// SBEH, or SSH: without the Gaussian energy, a constant there.
  static Problem of(const model::Material& material, model::Model model,
                    std::shared_ptr<const Basis> basis);
};

/// Unknowns of a curve and the coefficients c of its order (empty without order), and back.
Eigen::VectorXd pack(const Curve& curve, const Eigen::VectorXd& c = {});
Curve curve_of(const Problem& problem, const Eigen::VectorXd& y);
Eigen::VectorXd order_of(const Problem& problem, const Eigen::VectorXd& y);

/// Σ, −P, χ, c and −μ_β: what multiplies those held in the Lagrangian.
using Multipliers = Eigen::VectorXd;  // number of constraints

/// Value and first derivatives.
struct Expansion {
  double energy;
  Eigen::VectorXd gradient;  // of U
  Eigen::VectorXd measures;  // those held
  Eigen::MatrixXd jacobian;  // of the measures, one row each
  double moment = 0;         ///< c = (k_ad π/A)(W₂ − W₂⁰) where the stiffness is finite
  /// Likewise (∂W₂ − c/(π k_ad) ∂A) √(π k_ad/A), whose square is of the Hessian; else empty
  Eigen::VectorXd of_moment;
};
/// Empty where the curve runs through the axis.
std::optional<Expansion> expand(const Problem& problem, const Eigen::VectorXd& y);
/// Second derivatives of 𝓛; only where `expand` is not empty.
Eigen::MatrixXd hessian(const Problem& problem, const Eigen::VectorXd& y,
                        const Multipliers& multipliers);

/// The energy by parts, for reports; that of the area difference is left out.
model::EnergyDensity<double> energy_parts(const Problem& problem, const Eigen::VectorXd& y);
/// H on the points, and at the first and the last pole.
Eigen::VectorXd mean_curvature(const Curve& curve);
Eigen::Vector2d pole_curvatures(const Curve& curve);

/// 4π, 4πV_r/3, 0, W₂⁰, 0: what those held shall be.
Eigen::VectorXd target_of(const Problem& problem, double reduced_volume);
/// Multipliers which balance the gradient best.
Multipliers estimate_multipliers(const Expansion& at);

}  // namespace sbeh::axisym::spectral
