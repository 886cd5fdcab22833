// The second variation of a stationary state's Lagrangian by fields that go with cos mφ.
#pragma once

#include "axisym/modes/constrained_inverse.h"
#include "axisym/modes/parity.h"
#include "axisym/stationary/newton_system.h"

#include <array>

namespace sbeh::axisym {

using NodeChain = model::ChainMatrix<node_unknowns>;

/// For displacements x + Σ d_i φ_i n_i cos mφ along the node normals, and H, β, Λ with them, the quadratic form is
/// π (powers_0 + m² powers_1 + m⁴ powers_2), for m = 0 twice that: the exact one of the discrete curve and the smooth
/// angle. Unknowns as in NewtonSystem, node by node d, Λ, H, β, of the nodes of `sector`.
struct SecondVariation {
  Sector sector;
  std::array<NodeChain, 3> powers;
  NodeChain mass;  ///< ∫(u² + b²) r ds, for SSH ∫u² r ds
  /// In columns, for m = 0, the first variations of area (that of the lipids at full order) and volume, and of ∫β dS where that is conserved.
  Eigen::MatrixXd constraints;
  /// With an area difference, for m = 0: the first variation of W₂ and A/(2π² k_ad).
  SoftConstraint moment;
  bool has_order;    ///< otherwise β is pinned
  double stiffness;  ///< κ of the largest order: the scale of the eigenvalues
  StationaryState state;

  /// The form of m, without its π; what is not free has a 1 on the diagonal.
  NodeChain form(int m, Parity parity) const;
  /// The mass of what is free.
  NodeChain mass_of(int m, Parity parity) const;
  /// In columns what m and the parity must keep.
  Eigen::MatrixXd constraints_of(int m, Parity parity) const;
  /// Likewise what the area difference adds to the form.
  SoftConstraint moment_of(int m, Parity parity) const;

 private:
  Eigen::VectorXd folded(const Eigen::VectorXd& row, Parity parity) const;
};

/// At a stationary state. The material is that of its place, L included.
SecondVariation second_variation(const model::Material& material, model::Model model,
                                 const StationaryState& state);

/// Upside down nothing changes its sign; Λ and d go along the normals.
inline Mirror<node_unknowns> node_mirror() { return Mirror<node_unknowns>::Ones(); }

}  // namespace sbeh::axisym
