// Branches of critical points along L at one reduced volume, on elements graded towards the rim.
//
// Shapes are symmetric top to bottom here. The branch is followed by its own length, so that folds are no
// obstacle, minima or not.
#pragma once

#include "axisym/curve.h"
#include "axisym/rim/basis.h"
#include "axisym/spectral/newton.h"
#include "model/numerics/continuation.h"

namespace sbeh::axisym::spectral {

/// A critical point, or a guess of one.
struct RimState {
  double L;
  Eigen::VectorXd y;  // unknowns
  Multipliers multipliers;
};

/// A critical point with the direction of its branch: (y, L), of unit length (root mean square over y,
/// and L).
struct RimPathState : RimState {
  Eigen::VectorXd tangent;  // unknowns + 1
  double parameter() const { return L; }
  double slope() const { return tangent[tangent.size() - 1]; }  ///< the tangent's L
};

/// Whose critical points: a material but for L, a reduced volume, and which rims are admitted.
struct RimProblem {
  using Solution = RimState;
  using Point = RimPathState;
  static constexpr model::ContinuationLimits limits{
      .most_iterations = 12, .tolerance = 1e-9, .far = 0.5, .fold = 1e-9};

  model::Material material;  ///< with_L1(L) of it
  double reduced_volume;
  Rim rim;
  RimMesh mesh;
  std::shared_ptr<const Basis> basis;  // rim_basis(rim, mesh)

  RimProblem(const model::Material& m, double v, Rim r, const RimMesh& elements)
      : material(m), reduced_volume(v), rim(r), mesh(elements), basis(rim_basis(r, elements)) {}

  Problem at(double L) const { return {material.with_L1(L), basis, true}; }
  /// ψ of a state at every node, pole and rim included, and β.
  Eigen::VectorXd angles_at_nodes(const Eigen::VectorXd& y) const;
  Eigen::VectorXd order_at_nodes(const Eigen::VectorXd& y) const;
  /// Unknowns of a curve of this length with these values at the nodes; those that the rim prescribes are
  /// not used.
  Eigen::VectorXd unknowns(double length, const Eigen::VectorXd& psi,
                           const Eigen::VectorXd& beta) const;
  Eigen::VectorXd target() const { return target_of(at(1), reduced_volume); }
};

/// Newton's method at the L of the guess. Empty when it does not converge in a few steps, or goes far.
std::optional<RimState> solve(const RimProblem& problem, RimState guess);

/// The minimum at this L next to y. Empty where there is none.
std::optional<RimState> minimise(const RimProblem& problem, double L, const Eigen::VectorXd& y);

/// The state with its tangent, pointing the way of `forward`, or of growing L without it.
std::optional<RimPathState> with_tangent(const RimProblem& problem, const RimState& s,
                                         const Eigen::VectorXd* forward = nullptr);

// What model::ContinuationSystem asks for.
std::optional<RimState> predicted(const RimProblem& problem, const RimPathState& from, double ds);
std::optional<double> newton_step(const RimProblem& problem, RimState& s, const RimPathState& from,
                                  double ds);
bool continues(const RimProblem& problem, const RimPathState& from, const RimPathState& next,
               double ds);
using model::advance, model::arc_step, model::locate_fold;

/// Number of axisymmetric directions, symmetric top to bottom or not, in which U falls to second order,
/// area and volume kept; a kink stays one. At a fold, where one eigenvalue is zero, it is left to
/// rounding.
int negative_directions(const RimProblem& problem, const RimState& s);

/// The whole curve from pole to pole, three P3 elements for each of the rim mesh and side: nodes are exact,
/// what is between them is interpolated. The equator is at z = 0.
State profile_of(const RimProblem& problem, const Eigen::VectorXd& y);

}  // namespace sbeh::axisym::spectral
