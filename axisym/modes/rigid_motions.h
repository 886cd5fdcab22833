// The motions of a state as a whole, which cost nothing.
#pragma once

#include "axisym/modes/second_variation.h"

#include <vector>

namespace sbeh::axisym {

/// A velocity of rigid motion that goes with cos mφ in the meridian plane and with sin mφ across: along the axis for
/// m = 0, across it and about an axis across for m = 1.
struct RigidVelocity {
  double along = 0, across = 0, turn = 0;
  double middle = 0;  ///< z of the axis across

  Eigen::Vector2d meridian(const Eigen::Vector2d& x) const {
    return {across + turn * (x[1] - middle), along - turn * x[0]};
  }
  double around(const Eigen::Vector2d& x) const { return -across - turn * (x[1] - middle); }
};

/// At the nodes of the sector: u cos mφ along the normal; and b cos mφ, what becomes of the order at fixed (s, φ) when it
/// stays on its material.
struct RigidMotion {
  RigidVelocity velocity;
  Field u, b;
};

/// Those of an m and a parity, orthonormal in the mass ∫(u² + b²) r ds of these. Without the rotation of a sphere,
/// which moves nothing.
std::vector<RigidMotion> rigid_motions(const SecondVariation& second, int m, Parity parity,
                                       const NodeChain& mass);

/// (u, b) of motions in the unknowns of SecondVariation, in columns; without columns where there are none.
Eigen::MatrixXd unknowns_of(const std::vector<RigidMotion>& motions);

}  // namespace sbeh::axisym
