// Branches of critical points along L at one reduced volume, on elements graded towards the rim.
//
// Shapes are symmetric top to bottom here. The branch is followed by its own length, so that folds are no
// obstacle, minima or not.
#pragma once

#include "axisym/rim/basis.h"
#include "axisym/spectral/newton.h"

namespace sbeh::axisym::spectral {

/// Whose critical points: a material but for L, a reduced volume, and which rims are admitted.
struct RimProblem {
  model::Material material;  ///< with_L(L) of it
  double reduced_volume;
  Rim rim;
  RimMesh mesh;
  std::shared_ptr<const Basis> basis;  // rim_basis(rim, mesh)

  RimProblem(const model::Material& m, double v, Rim r, const RimMesh& elements)
      : material(m), reduced_volume(v), rim(r), mesh(elements), basis(rim_basis(r, elements)) {}

  Problem at(double L) const { return {material.with_L(L), basis, true}; }
  /// ψ of a state at every node, pole and rim included, and β.
  Eigen::VectorXd angles_at_nodes(const Eigen::VectorXd& y) const;
  Eigen::VectorXd order_at_nodes(const Eigen::VectorXd& y) const;
  /// Unknowns of a curve of this length with these values at the nodes; those that the rim prescribes are
  /// not used.
  Eigen::VectorXd unknowns(double length, const Eigen::VectorXd& psi,
                           const Eigen::VectorXd& beta) const;
  Eigen::VectorXd target() const { return target_of(at(1), reduced_volume); }
};

/// A critical point, or a guess of one.
struct RimState {
  double L;
  Eigen::VectorXd y;  // unknowns
  Multipliers multipliers;
};

/// A critical point with the direction of its branch: (y, L), of unit length (root mean square over y,
/// and L).
struct RimPathState {
  RimState s;
  Eigen::VectorXd tangent;                                      // unknowns + 1
  double slope() const { return tangent[tangent.size() - 1]; }  ///< the tangent's L
};

/// Newton's method at the L of the guess. Empty when it does not converge in a few steps, or goes far.
std::optional<RimState> solve(const RimProblem& problem, RimState guess);

/// The minimum at this L next to y. Empty where there is none.
std::optional<RimState> minimise(const RimProblem& problem, double L, const Eigen::VectorXd& y);

/// The state with its tangent, pointing the way of `forward`, or of growing L without it.
std::optional<RimPathState> with_tangent(const RimProblem& problem, const RimState& s,
                                         const Eigen::VectorXd* forward = nullptr);

/// Newton on the hyperplane at distance ds along the tangent. Empty when it does not converge, or
/// arrives with a tangent so different that it must have jumped.
std::optional<RimPathState> arc_step(const RimProblem& problem, const RimPathState& from,
                                     double ds);

/// The fold between a state and the one ds further, where the tangent's L changes sign.
RimPathState locate_fold(const RimProblem& problem, const RimPathState& before,
                         const RimPathState& beyond, double ds);

/// Number of axisymmetric directions, symmetric top to bottom or not, in which U falls to second order,
/// area and volume kept; a kink stays one. At a fold, where one eigenvalue is zero, it is left to
/// rounding.
int negative_directions(const RimProblem& problem, const RimState& s);

}  // namespace sbeh::axisym::spectral
