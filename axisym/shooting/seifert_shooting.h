// The classical vesicle shapes by shooting: initial value problems from the poles, closed at the
// equator by Newton's method and followed along their branches. A witness of its own: nothing but the
// type of the result is shared with the finite elements.
#pragma once

#include "axisym/classical_shape.h"
#include "axisym/shooting/shooting_branch.h"

#include <span>
#include <vector>

namespace sbeh::axisym {

using ShootingOptions = shooting::Options;

/// The shapes of a branch at these reduced volumes, in their order; close neighbours are cheapest, but
/// the shapes do not depend on the path. Oblates and prolates start at the sphere, their common limit;
/// stomatocytes branch off the oblates, rise to a fold, and are meant beyond it, where the energy is
/// lower. Self-contact is judged on the polygon of the profile.
/// Throws shooting::NotOnBranch; std::invalid_argument outside (0, 1 − 1e-7] and 1;
/// std::runtime_error where shooting is too ill conditioned (prolates below 0.34).
std::vector<ClassicalShape> shoot_branch(Branch branch, std::span<const double> reduced_volumes,
                                         const ShootingOptions& options = {});

/// The five special points. All are solved again with a hundred times the tolerance and ten times the
/// series start: the error is what that changes, and 1e-12 for rounding.
SpecialPoints shoot_special_points(const ShootingOptions& options = {});

/// Where oblates or prolates with the spontaneous curvature of the options lose their symmetry, and the first fold of the
/// stomatocytes or pears that leave there; errors likewise. Throws std::runtime_error where shooting cannot follow.
struct LossAndFold {
  SpecialPoint loss, fold;
};
LossAndFold shoot_symmetry_loss(Branch branch, const ShootingOptions& options = {});

}  // namespace sbeh::axisym
