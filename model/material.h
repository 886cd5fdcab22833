// The physics of one membrane: elastic moduli, potential, viscosities, frictions.
#pragma once

#include "model/potential.h"

namespace sbeh::model {

/// Which equations of motion. SBEH has a free order β; the others keep β = 2/3 and have the same states
/// of rest: SSH (surface Stokes–Helfrich) and the two L² flows of the Helfrich energy.
enum class Model { SBEH, SSH, HelfrichLocal, HelfrichGlobal };

/// "SBEH", "SSH", "Helfrich-local" or "Helfrich-global".
const char* name(Model model);

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

/// The material parameters; all dimensionless, lengths in radii of the sphere of equal area.
/// The defaults are the paper's. A residual bending stiffness k0 and a spontaneous curvature H0 are
/// added to the paper's energy; see equations.md.
struct Material {
  double L1 = 0.05;  ///< elastic constants of the Q-tensor; one-constant approximation: L1 = L,
  double L2 = 0;     ///< L2 = L3 = 0
  double L3 = 0;
  Potential potential;               ///< u(β)
  double viscosity = 1;              ///< μ >= 0, of the surface flow
  double immobility = 1;             ///< M > 0, resistance of the order to change
  double friction_tangential = 0.1;  ///< γ_∥ >= 0, against the surroundings
  double friction_normal = 0.1;      ///< γ_⊥ >= 0
  double order_viscosity = 0;        ///< ξ, how the order changes the viscosity
  double residual_stiffness = 0;     ///< k0 >= 0, bending stiffness at vanishing order
  double spontaneous_curvature = 0;  ///< H0, same sign as the trace H (−2 on the unit sphere)

  /// l₁ of the distortion energy (l₁/2)|∇β|².
  double l1() const { return (6 * L1 + L2 + L3) / 4; }

  /// κ(β) = (9/4)β²(2L₁ + L₂ + L₃) + k₀ of the bending energy (κ/2)(H − H₀)².
  template <class T>
  T kappa(const T& beta) const {
    return splay() * beta * beta + residual_stiffness;
  }
  /// κ'(β)
  template <class T>
  T kappa_slope(const T& beta) const {
    return 2 * splay() * beta;
  }
  /// κ_G(β) = −(9/4)β²(2L₁ + L₃) of the Gaussian energy κ_G K.
  template <class T>
  T kappa_gauss(const T& beta) const {
    return -saddle_splay() * beta * beta;
  }
  /// κ_G'(β)
  template <class T>
  T kappa_gauss_slope(const T& beta) const {
    return -2 * saddle_splay() * beta;
  }
  /// η(β) = μ(1 + ξβ/2)² of the viscous stress ησ(V).
  double eta(double beta) const {
    const double factor = 1 + order_viscosity * beta / 2;
    return viscosity * factor * factor;
  }
  /// (3/2)(M + μξ²/2), what multiplies β̇ in the order equation.
  double order_drag() const {
    return 1.5 * (immobility + viscosity * order_viscosity * order_viscosity / 2);
  }

  /// One-constant approximation with elastic constant L, the rest as here.
  Material with_L(double L) const;

  /// Throws std::invalid_argument with name, value and constraint unless the energy is bounded
  /// below in the gradients (l₁ > 0, −2κ <= κ_G <= 0) and the dissipation is positive.
  void validate() const;

 private:
  double splay() const { return 2.25 * (2 * L1 + L2 + L3); }
  double saddle_splay() const { return 2.25 * (2 * L1 + L3); }
};

/// The material as the model's flow has it: where has_own_drag, without viscosity and with friction 1,
/// under a global area constraint against the normal velocity alone.
Material effective(const Material& material, Model model);

}  // namespace sbeh::model
