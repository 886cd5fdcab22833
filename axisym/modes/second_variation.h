// The second variation of a stationary state's Lagrangian by fields that go with cos mφ.
#pragma once

#include "axisym/stationary/stationary.h"
#include "model/numerics/band_matrix.h"

#include <array>

namespace sbeh::axisym {

/// For displacements x + Σ d_i φ_i n_i cos mφ along the node normals, and H, β, Λ with them, the quadratic form is
/// π (powers_0 + m² powers_1 + m⁴ powers_2), for m = 0 twice that: the exact one of the discrete curve and the smooth
/// angle. Unknowns as in NewtonSystem: node by node d, Λ, H, β.
struct SecondVariation {
  std::array<model::BandMatrix, 3> powers;
  model::BandMatrix mass;       ///< ∫(u² + b²) r ds, for SSH ∫u² r ds
  Eigen::MatrixXd constraints;  ///< 4 nodes x 2: for m = 0, the first variations of area and volume
  bool has_order;               ///< otherwise β is pinned
  double stiffness;             ///< κ of the largest order: the scale of the eigenvalues
  StationaryState state;

  /// The form of m less shift · mass, both without their π; what is not free has a 1 on the diagonal.
  model::BandMatrix shifted(int m, double shift) const;
  /// The mass of what is free for m.
  model::BandMatrix mass_of(int m) const;
};

/// At a stationary state. The material is that of its place, L included.
SecondVariation second_variation(const model::Material& material, model::Model model,
                                 const StationaryState& state);

}  // namespace sbeh::axisym
