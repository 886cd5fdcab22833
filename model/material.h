// The physics of one membrane: elastic moduli, potential, viscosities, frictions.
#pragma once

#include "model/names.h"
#include "model/parameter.h"
#include "model/potential.h"

#include <array>
#include <numbers>
#include <optional>

namespace sbeh::model {

/// Which equations of motion. SBEH has a free order β; the others keep β = 2/3 and have the same states
/// of rest: SSH (surface Stokes–Helfrich) and the two L² flows of the Helfrich energy.
enum class Model { SBEH, SSH, HelfrichLocal, HelfrichGlobal };
constexpr auto names(Model) {
  return std::array{"SBEH", "SSH", "Helfrich-local", "Helfrich-global"};
}

inline bool has_free_order(Model model) { return model == Model::SBEH; }

/// The model of which a scan has the states of rest: SBEH, or SSH for all others.
inline Model rest_model(Model model) { return has_free_order(model) ? Model::SBEH : Model::SSH; }

/// Whether the model says what resists the flow, instead of the material: no viscosity, friction 1.
inline bool has_own_drag(Model model) {
  return model == Model::HelfrichLocal || model == Model::HelfrichGlobal;
}

/// What keeps its area: every piece of the surface; or only the whole, then the pressure p is a number
/// and the surface moves along its normals alone.
enum class AreaConstraint { local, global };
inline AreaConstraint area_constraint(Model model) {
  return model == Model::HelfrichGlobal ? AreaConstraint::global : AreaConstraint::local;
}

/// The fully ordered state.
inline constexpr double full_order = 2.0 / 3.0;

/// The elasticity of the area difference of the two leaflets, (k_ad π/(2A))(W₂ − W₂⁰)² with W₂ = ∫H dS (Miao, Seifert,
/// Wortis, Döbereiner, Phys. Rev. E 49, 5389, 1994).
struct AreaDifference {
  double stiffness = 0;  ///< k_ad >= 0; infinite in the bilayer-coupling model, where W₂ = W₂⁰
  double W2 = 0;         ///< W₂⁰ = −8π Δa₀

  bool is_there() const { return stiffness > 0; }
  /// 1/(π k_ad), 0 where it is infinite: W₂ − W₂⁰ = A c/(π k_ad), c the moment that it makes.
  double compliance() const { return 1 / (std::numbers::pi * stiffness); }

  /// 0 where the stiffness is infinite, for W₂ is W₂⁰ then.
  double energy(double area, double total) const {
    const double excess = total - W2;
    if (!is_there() || compliance() == 0) return 0;
    return excess * excess / (2 * area * compliance());  // (E6)
  }

  /// Throws std::invalid_argument where a flow cannot begin with this ∫ H dS, which the bilayer-coupling model keeps.
  void check_start(double total) const;

  bool operator==(const AreaDifference&) const = default;
};

/// What becomes of the order as a whole. It relaxes everywhere by itself; or ∫β dS is conserved, as if order were exchanged at
/// any distance, or by diffusion along the surface.
enum class OrderDynamics { relaxing, conserved, diffusive };
constexpr auto names(OrderDynamics) { return std::array{"relaxing", "conserved", "diffusive"}; }

/// The material parameters; all dimensionless, lengths in radii of the sphere of equal area. Their meanings
/// and ranges are in the table below; the defaults are the paper's. A residual bending stiffness k0 a
/// spontaneous curvature H0 and a flexoelectric coupling f are added to the paper's energy; see equations.md.
struct Material {
  double L1 = 0.05, L2 = 0, L3 = 0;
  Potential potential;
  double viscosity = 1;
  double immobility = 1;
  double friction_tangential = 0.1, friction_normal = 0.1;
  double order_viscosity = 0;
  double residual_stiffness = 0;
  double spontaneous_curvature = 0;
  Polynomial flexoelectric{{0}};
  AreaDifference area_difference{};
  OrderDynamics order = OrderDynamics::relaxing;
  std::optional<double> mean_order{};      ///< (1/A)∫β dS where the order is conserved
  std::optional<double> order_mobility{};  ///< M_β where it diffuses, 1 where it is not given
  Polynomial kappa_powers{}, kappa_gauss_powers{};  ///< empty: by the elastic constants and k₀
  Polynomial
      lipid_density{};  ///< n(β), lipids per area, up to a factor; empty: the same for all orders

  /// l₁ of the distortion energy (l₁/2)|∇β|².
  double l1() const { return (6 * L1 + L2 + L3) / 4; }

  /// κ(β) of the bending energy (κ/2)(H − H₀)², where it is not given (9/4)β²(2L₁ + L₂ + L₃) + k₀.
  template <class T>
  T kappa(const T& beta) const {
    if (!kappa_powers.empty()) return kappa_powers.value(beta);
    return splay() * beta * beta + residual_stiffness;
  }
  /// κ'(β)
  template <class T>
  T kappa_slope(const T& beta) const {
    return kappa_secant(beta) * beta + kappa_slope_at_zero();
  }
  /// (κ'(β) − κ'(0))/β, and κ'(0): what the order step has on either side.
  template <class T>
  T kappa_secant(const T& beta) const {
    return kappa_powers.empty() ? T(2 * splay()) : kappa_powers.secant(beta);
  }
  double kappa_slope_at_zero() const { return kappa_powers.slope_at_zero(); }
  /// κ_G(β) of the Gaussian energy κ_G K, where it is not given −(9/4)β²(2L₁ + L₃).
  template <class T>
  T kappa_gauss(const T& beta) const {
    if (!kappa_gauss_powers.empty()) return kappa_gauss_powers.value(beta);
    return -saddle_splay() * beta * beta;
  }
  /// κ_G'(β), and its parts as of κ'
  template <class T>
  T kappa_gauss_slope(const T& beta) const {
    return kappa_gauss_secant(beta) * beta + kappa_gauss_slope_at_zero();
  }
  template <class T>
  T kappa_gauss_secant(const T& beta) const {
    return kappa_gauss_powers.empty() ? T(-2 * saddle_splay()) : kappa_gauss_powers.secant(beta);
  }
  double kappa_gauss_slope_at_zero() const { return kappa_gauss_powers.slope_at_zero(); }
  /// With f + c for f: what the moment c of the area difference makes of a membrane.
  Material at_moment(double c) const;
  /// With an order that is not conserved: what a model without a free order has.
  Material with_uniform_order() const;
  bool conserves_order() const { return order != OrderDynamics::relaxing; }
  /// With u − μ_β(β − β̄) for u: what the chemical potential μ_β of a conserved order of mean β̄ makes of a membrane.
  Material at_chemical_potential(double mu) const;
  /// Whether lipids have another area when they are ordered: then their number is kept, not the area.
  bool has_lipid_density() const { return !lipid_density.empty(); }
  /// n(β)/n(2/3): what area the lipids of a unit area have at full order.
  template <class T>
  T packing(const T& beta) const {
    if (!has_lipid_density()) return T(1);
    return lipid_density.value(beta) * (1 / lipid_density.value(full_order));
  }
  /// ∂/∂β of it
  template <class T>
  T packing_slope(const T& beta) const {
    if (!has_lipid_density()) return T(0);
    return lipid_density.slope(beta) * (1 / lipid_density.value(full_order));
  }
  /// a'/a = −n'/n of the area per lipid a = 1/n: Div_C V of a membrane whose order changes with the rate 1.
  double expansion(double beta) const { return -packing_slope(beta) / packing(beta); }
  /// κ(β)(H − H₀) + f(β), the moment that bends: ∂(energy density)/∂H.
  template <class T, class S>
  T moment(const S& beta, const T& H) const {
    return T(kappa(beta)) * (H - spontaneous_curvature) + T(flexoelectric.value(beta));
  }
  /// ∂/∂β of it: κ'(β)(H − H₀) + f'(β)
  template <class T, class S>
  T moment_slope(const S& beta, const T& H) const {
    return T(kappa_slope(beta)) * (H - spontaneous_curvature) + T(flexoelectric.slope(beta));
  }
  /// H₀ − f/κ at full order, the H₀ with which SSH has the same shapes.
  double preferred_curvature() const {
    const double f = flexoelectric.value(full_order);
    return f == 0 ? spontaneous_curvature : spontaneous_curvature - f / kappa(full_order);
  }
  /// η(β) = μ(1 + ξβ/2)² of the viscous stress ησ(V).
  double eta(double beta) const {
    const double factor = 1 + order_viscosity * beta / 2;
    return viscosity * factor * factor;
  }
  /// m_β = (3/2)(M + μξ²/2), what multiplies β̇ in the order equation.
  double order_drag() const {
    return 1.5 * (immobility + viscosity * order_viscosity * order_viscosity / 2);
  }

  /// (μξ/2)(1 + ξβ/2), what β̇ makes of an isotropic stress and Div_C V of a force on the order.
  double order_dilation_drag(double beta) const {
    return viscosity * order_viscosity / 2 * (1 + order_viscosity * beta / 2);
  }
  /// m_β and what the area that goes along with the order adds, of ∫ order_drag(β) β̇² dS.
  double order_drag(double beta) const {
    return has_lipid_density() ? order_drag() + 2 * order_dilation_drag(beta) * expansion(beta)
                               : order_drag();
  }

  /// Whether nothing resists a rigid motion.
  bool frictionless() const { return friction_tangential == 0 && friction_normal == 0; }

  /// One-constant approximation with elastic constant L, the rest as here.
  Material with_L(double L) const;
  /// L where it is one of three: L1 = L, the rest as here.
  Material with_L1(double L) const;

  /// L2, L3, f and k_ad, and κ and κ_G where they are given, times a factor.
  Material with_given_scaled(double factor) const;
  /// Whether κ, κ_G or f is given.
  bool has_functions() const {
    return !kappa_powers.empty() || !kappa_gauss_powers.empty() || !flexoelectric.vanishes();
  }
  /// Whether these, L2, L3 or an area difference are there: states do not go along with L then.
  bool has_given() const {
    return has_functions() || L2 != 0 || L3 != 0 || area_difference.is_there();
  }

  /// The same κ(β), but κ_G = 0. No material of its own: only what a uniform order feels, whose κ_G K adds up to a constant.
  Material without_gaussian() const;

  /// Throws std::invalid_argument with name, value and constraint unless the energy is bounded
  /// below in the gradients (l₁ > 0, −2κ <= κ_G <= 0; of given κ and κ_G for 0 <= β <= 1 κ >= 0) and the dissipation is positive.
  void validate() const;

  bool operator==(const Material&) const = default;

 private:
  double splay() const { return 2.25 * (2 * L1 + L2 + L3); }
  double saddle_splay() const { return 2.25 * (2 * L1 + L3); }
};

/// The table of its parameters.
template <maybe_const<Material> M>
void for_each_parameter(M& m, auto&& visit) {
  using P = Parameter;
  visit(P{"L1", any_number, "elastic constant; one-constant approximation: L1 = L"}, m.L1);
  visit(P{"L2", any_number, "elastic constant; one-constant approximation: 0"}, m.L2);
  visit(P{"L3", any_number, "elastic constant; one-constant approximation: 0"}, m.L3);
  visit(P{"potential", {}, "u(β), coefficients of its powers; bounded below"}, m.potential);
  visit(P{"viscosity", at_least(0), "μ, of the surface flow"}, m.viscosity);
  visit(P{"immobility", above(0), "M, resistance of the order to change"}, m.immobility);
  visit(P{"friction_tangential", at_least(0), "γ_∥, against the surroundings"},
        m.friction_tangential);
  visit(P{"friction_normal", at_least(0), "γ_⊥"}, m.friction_normal);
  visit(P{"order_viscosity", any_number, "ξ, how the order changes the viscosity"},
        m.order_viscosity);
  visit(P{"residual_stiffness", at_least(0), "k0, bending stiffness at vanishing order"},
        m.residual_stiffness);
  visit(P{"spontaneous_curvature", any_number,
          "H0, of the sign of the trace H (−2 on the unit sphere)"},
        m.spontaneous_curvature);
  visit(P{"kappa", {}, "κ(β), coefficients of its powers, instead of that by L1, L2, L3 and k0"},
        m.kappa_powers);
  visit(P{"kappa_gauss", {}, "κ_G(β), likewise"}, m.kappa_gauss_powers);
  visit(P{"flexoelectric", {}, "f(β) of f(β)H, coefficients of its powers: two sides that differ"},
        m.flexoelectric);
  visit(P{"lipid_density", {}, "n(β), lipids per area up to a factor, coefficients of its powers"},
        m.lipid_density);
  visit(
      P{"area_difference",
        {},
        "of the two leaflets: stiffness k_ad, inf in the bilayer-coupling model, and W2 = −8π Δa₀"},
      m.area_difference);
  visit(P{"order", {}, "relaxing; or conserved as a whole: at once, or diffusive"}, m.order);
  visit(P{"mean_order", between(-0.5, 1), "(1/A)∫β dS of an order that is conserved"},
        m.mean_order);
  visit(P{"order_mobility", above(0), "M_β of β̇ = Div(M_β ∇μ_β), of an order that is diffusive"},
        m.order_mobility);
}

/// The material as the model's flow has it: where has_own_drag, without viscosity and with friction 1,
/// under a global area constraint against the normal velocity alone; with a uniform order where that is not free.
Material effective(const Material& material, Model model);

}  // namespace sbeh::model
