// One linearised stationary problem: assembled, factored, and solved for any right-hand side.
#pragma once

#include "axisym/stationary/lagrangian.h"

namespace sbeh::axisym {

/// Position of a node's unknown in the global vector.
inline int index(Eigen::Index node, NodeUnknown c) { return node_unknowns * int(node) + c; }

/// Visits the unknowns that are not free: the north pole's displacement, of which half a state has no need, and the
/// order of SSH.
template <class Visit>
void for_each_pinned(model::Model model, const Sector& sector, Visit&& visit) {
  if (!sector.is_half) visit(index(0, node_d));
  if (!model::has_free_order(model))
    for (int i = 0; i < sector.nodes(); ++i) visit(index(i, node_beta));
}

/// A direction or a step in all unknowns; fields are nodal, `d` along the node normals.
struct Increment {
  Field d, Lambda, H, beta;
  double tension = 0, pressure = 0, moment = 0, chemical_potential = 0;
  double mu = 0;  ///< parameter of a path; 0 where there is none
};

/// Largest displacement or change of order in a step.
double largest_change(const Increment& step);

/// The equation row·(d, β) + row_μ δμ = right-hand side of a further unknown μ, the parameter of a path.
struct PathEquation {
  Eigen::VectorXd gradient_rate;  // 4 nodes of the whole: ∂(gradient of 𝓛)/∂μ
  double volume_rate;             ///< ∂V₀/∂μ
  double W2_rate;                 ///< ∂W₂⁰/∂μ
  Increment row;                  ///< only d, β and μ are used
};

/// Area that every node stands for, ∫ |φ_i| dS.
Field node_areas(const Nodes& X);

/// Largest force (normal) or order residual per area of its node, of a state over X.
double residual_of(const LagrangianDerivatives& lagrangian, model::Model model, const Nodes& X);

/// The state moves by scale · step along its node normals.
void displace(const Increment& step, double scale, StationaryState& state);

/// Over a half, states are symmetric top to bottom and all steps too: the poles move alike. Over the whole, the north
/// pole is held.
class NewtonSystem {
 public:
  NewtonSystem(const model::Material& material, model::Model model, const Sector& sector);

  /// Assembles at the state and factors. False when the matrix is singular or not finite.
  bool linearise(const StationaryState& state);

  /// The Newton step towards `target`; on a path, μ changes too so that its equation holds
  /// with right-hand side `arc`. False when singular.
  bool newton_step(const Target& target, Increment& step);
  /// The step from another state nearby, whose own matrix is not needed.
  bool newton_step_from(const StationaryState& state, const Target& target, Increment& step);
  bool newton_step(const Target& target, const PathEquation& path, double arc, Increment& step);
  /// The change of the solution per change of μ (mu = 1).
  bool tangent(const Eigen::VectorXd& gradient_rate, double volume_rate, double W2_rate,
               Increment& direction);
  /// The direction along the branch with row·(d, β, μ) = 1; regular at folds as well.
  bool tangent(const PathEquation& path, Increment& direction);

  /// Sign of the determinant of the bordered matrix: flips at a fold, over the whole also where the symmetry may be lost.
  /// After a step or a tangent.
  int determinant_sign() const { return determinant_sign_; }

 private:
  Eigen::VectorXd folded(const Eigen::VectorXd& load) const;
  // What area, volume, moment and order miss; `there` is a LagrangianDerivatives or LagrangianGradient.
  template <class Derivatives>
  Eigen::Vector4d miss(const Derivatives& there, const Target& target, double moment) const;
  bool solve(const Eigen::VectorXd& rhs, const Eigen::VectorXd& border_rhs,
             const PathEquation* path, Increment& out);

  model::Material material_;
  model::Model model_;
  LagrangianDerivatives derivatives_;
  double moment_ = 0;  // of the state of linearise
  int determinant_sign_ = 0;
};

}  // namespace sbeh::axisym
