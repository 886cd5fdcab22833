// Stationary axisymmetric shapes by minimisation over spectral curves: a witness that shares nothing with
// the finite elements but the energy per area.
//
// Ceres minimises ½∫H² dS as a sum of squares with shifted penalties (augmented Lagrangian) over the
// tangent angle ψ = πx + Σ b_k sin(kπx); Newton's method with the exact second variation takes the minimum
// to rounding and proves it one. There are as many modes as it takes, from 18 for oblates to 240 for the
// narrowest rims; the energies' relative errors are about 1e-13.
#pragma once

#include "axisym/classical_shape.h"
#include "model/energy_density.h"
#include "model/numerics/profile.h"

#include <array>
#include <optional>
#include <span>
#include <vector>

namespace sbeh::axisym {

/// The minimum of F on a branch, sought from a spheroid or an invaginated sphere.
/// Oblates and prolates are minima among the shapes symmetric top to bottom. Empty where the search does
/// not end in a resolved minimum of the class asked for. Stomatocytes are found from 0.1 to 2e-5 below
/// their largest volume, 0.66085.
/// Throws std::invalid_argument unless 0 < V_r < 1.
std::optional<ClassicalShape> minimise_classical(Branch branch, double reduced_volume);

/// The branch at these volumes, in their order, each from the one before; without those where it has no
/// minimum.
std::vector<ClassicalShape> minimise_branch(Branch branch, std::span<const double> reduced_volumes);

/// Two resolutions; the errors are their difference and a bound on rounding.
SpecialPoints minimise_special_points();

/// A minimum of U over shape and order, or of SSH over shape; oblates and prolates among those symmetric top to bottom.
struct EnergyMinimum {
  double reduced_volume;
  double energy;                       ///< U
  model::EnergyDensity<double> parts;  ///< integrated over the surface
  double area_difference;         ///< (k_ad π/(2A))(W₂ − W₂⁰)²; with the parts it is U
  double order_min;               ///< smallest β
  double H_abs_max;               ///< largest |H|
  std::array<double, 2> H_poles;  ///< H at the first and the last pole
  double pressure;                ///< P = ∂U/∂V at fixed area
  double tension;                 ///< Σ = −∂U/∂A at fixed volume; of lipids at full order
  double moment;                  ///< c = −∂U/∂W₂⁰
  double chemical_potential;      ///< μ_β of a conserved order, else 0
  double stiffness;               ///< smallest eigenvalue of the second variation, > 0
  model::Profile profile;         ///< along the whole curve
};

/// The minimum to which the classical shape of the branch leads: of SSH in steps of H₀, f and W₂⁰, whose way begins where no
/// moment acts; of SBEH from there with β = 2/3, or the mean order where that is conserved, directly or in steps of all that is
/// elastic. Empty where there is none on the way that is smooth, or resolved: beyond a fold, or with a narrow neck.
/// `model` is SBEH or SSH. Throws std::invalid_argument unless 0 < V_r < 1, the material is valid, and the branch is not that of pears.
std::optional<EnergyMinimum> minimise_energy(const model::Material& material, model::Model model,
                                             double reduced_volume, Branch start = Branch::oblate);

}  // namespace sbeh::axisym
