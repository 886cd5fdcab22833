// What one step in time makes stationary (Onsager's principle), in the labels of model/equations.md:
//
//   U(X⁺, β⁺) + τ D(u/τ, (β⁺ − β)/τ)/2,   Div_C u = c,   A(X⁺) = A₀,   V(X⁺) = V₀
//
// with D the dissipation on the old surface, u = Σ (d_i n_i + s_i t_i + s'_i t'_i) φ_i what the material moves by, along the node
// normals and two tangents, and X⁺ = X + Y + Σ d_i φ_i n_i, Y a motion of the mesh along itself. U with its mean curvature is that of
// stationary/lagrangian.h. At the stationary point U⁺ + τ D/2 <= U for any τ, where it is a minimum, and (V1) … (V12), (B1) … (B5) hold
// in the first order of τ. c is 0 but for the drift of A; the pressure p has the mean 0, its constant is the tension Σ.
#pragma once

#include "surface3d/curvature.h"
#include "surface3d/stationary/lagrangian.h"

namespace sbeh::surface3d {

/// The unknowns of a step: at the nodes those of a stationary state and two tangential displacements, then p at the P2 nodes.
struct StepLayout {
  /// Of a material with lipid_density p meets the order, too.
  StepLayout(const Triangulation& mesh, const model::Material& material, model::Model model);

  StationaryLayout state;
  int per_node;
  SparsePattern pattern;
  std::vector<int> unknowns;  ///< of a stationary state, among those of the step
  std::vector<int> places;    ///< of the entries of its Hessian, in a matrix of `pattern`
  int size() const { return pressure() + state.mesh.quadratic_nodes; }
  int pressure() const { return per_node * state.mesh.nodes; }  ///< where p begins
  /// The unknown c of all nodes; c = state.per_node + k: along the tangent k.
  auto all(int c) const {
    return Eigen::seqN(Eigen::Index(c), Eigen::Index(state.mesh.nodes), Eigen::Index(per_node));
  }
};

/// From where a step goes.
struct StepBase {
  const State& old;
  const Curvature& curvature;            ///< of it
  const std::array<Nodes, 2>& tangents;  ///< at its nodes
  const Nodes& Y;                        // 3 x nodes, tangential
  double tau;
};

/// τD/2 as ½ xᵀ matrix x + linear·x and a constant, x the unknowns, β as it is; with Div_C u against p, and with lipid_density
/// n/n(2/3) Div_C u + n'/n(2/3) (β⁺ − β + (u − Y)·∇β).
struct StepResistance {
  SparseMatrix matrix;
  Eigen::VectorXd linear;
  Eigen::MatrixXd
      borders;  ///< unknowns x 7: c, and the six conditions that the friction of u has no resultant and no moment
};
void assemble(const model::Material& material, const StepLayout& layout, const StepBase& base,
              StepResistance& out);

}  // namespace sbeh::surface3d
