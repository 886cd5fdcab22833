// Motions of a stationary state that cost nothing, and the measure in which perturbations are compared.
#pragma once

#include "surface3d/stationary/lagrangian.h"

namespace sbeh::surface3d {

/// ∫ (u u' + b b') dS of perturbations: u = Σ d_i φ_i n_i·ν along the normal, b the change of the order on nodes that move
/// so, in the unknowns of the layout.
SparseMatrix perturbation_mass(const StationaryLayout& layout, const StationaryState& state,
                               const Nodes& normals);

/// Translations and turns W as perturbations, u = W·ν, b = −W·∇β; those that move nothing, the turns of a surface of
/// revolution about its axis and all of a sphere, are no motions.
struct RigidMotions {
  Eigen::MatrixXd loads;  ///< in columns: the mass times each, (u_c φ_i n_i·ν) and (b_c φ_i) dS
  double least;           ///< of the motions' sizes, the largest being 1
  double dropped;         ///< the largest size of those that are none, or 0
  double nothing;         ///< below which they are none: what errors of the normals make
};
RigidMotions rigid_motions(const StationaryLayout& layout, const StationaryState& state,
                           const Nodes& normals);

}  // namespace sbeh::surface3d
