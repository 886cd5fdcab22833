// The classical vesicle shapes: stationary states of F = (κ/2)∫H² dS at fixed area and volume, on which
// the finite elements, shooting and minimisation must agree.
#pragma once

#include "model/names.h"

#include <Eigen/Core>

#include <array>
#include <vector>

namespace sbeh::axisym {

/// The branches of Seifert, Berndl and Lipowsky, Phys. Rev. A 44 (1991) 1182, without spontaneous
/// curvature, and the pears that leave its prolates where there is some (or an area difference). Oblates and prolates are symmetric top
/// to bottom, stomatocytes and pears are not.
enum class Branch { oblate, prolate, stomatocyte, pear };
constexpr auto names(Branch) { return std::array{"oblate", "prolate", "stomatocyte", "pear"}; }

constexpr bool is_symmetric(Branch branch) {
  return branch == Branch::oblate || branch == Branch::prolate;
}

/// Those that are there without spontaneous curvature.
inline constexpr std::array classical_branches{Branch::oblate, Branch::prolate,
                                               Branch::stomatocyte};

/// One shape, in the units of the sphere of the same area: R = 1, A = 4π.
struct ClassicalShape {
  Branch branch;
  double reduced_volume;  ///< V_r
  double energy;          ///< F/(8πκ), 1 on the sphere
  double H_pole;          ///< trace H, −2 on the unit sphere, at the pole where it is larger (the
                          ///< invaginated one of a stomatocyte)
  double pressure;    ///< P R³/κ, P = ∂F/∂V at fixed area: 6 d(energy)/dV_r along the branch
  double tension;     ///< Σ R²/κ, Σ = −∂F/∂A at fixed volume; 3PV = 2ΣA
  bool self_contact;  ///< the profile touches or crosses itself
  Eigen::Matrix2Xd profile;      // 2 x n: r, z along the whole curve, from the pole of H_pole on
  int negative_directions = -1;  ///< within axisymmetry; −1: this witness does not tell
};

/// A special point of the diagram with the error that its witness claims.
struct SpecialPoint {
  double reduced_volume;
  double energy;  ///< F/(8πκ)
  double error;   ///< of the reduced volume
};

/// The five special points of the classical diagram.
struct SpecialPoints {
  SpecialPoint prolate_oblate;        ///< equal energies, V_r about 0.65
  SpecialPoint oblate_stomatocyte;    ///< equal energies, V_r about 0.59
  SpecialPoint stomatocyte_fold;      ///< largest V_r of the stomatocytes, about 0.66
  SpecialPoint oblate_symmetry_loss;  ///< stomatocytes branch off the oblates, about 0.51
  SpecialPoint oblate_self_contact;   ///< the poles of the oblate touch, about 0.51
};

}  // namespace sbeh::axisym
