// The motions of a state as a whole, which cost nothing.
#pragma once

#include "axisym/modes/second_variation.h"

#include <vector>

namespace sbeh::axisym {

/// A velocity of rigid motion at the nodes: u cos mφ along the normal, v_t cos mφ along the meridian, v_φ sin mφ across;
/// and b cos mφ, what becomes of the order at fixed (s, φ) when it stays on its material, −v_t ∂_sβ.
struct RigidMotion {
  Field u, b, v_t, v_phi;
};

/// Those that go with cos mφ, orthonormal in the mass ∫(u² + b²) r ds of that m: the translation along the axis for m = 0, that across and
/// the rotation about an axis across for m = 1. Without the rotation of a sphere, which moves nothing.
std::vector<RigidMotion> rigid_motions(const StationaryState& state, int m,
                                       const model::BandMatrix& mass);

/// (u, b) in the unknowns of SecondVariation.
Eigen::VectorXd unknowns_of(const RigidMotion& motion);

}  // namespace sbeh::axisym
