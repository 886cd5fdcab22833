// Branches of rest states in one parameter μ, by their own length; folds, and where other branches leave.
//
// What goes from point to point is model/numerics/continuation.h; the length of a direction is the root mean square of
// displacements and changes of order over the nodes, and μ.
#pragma once

#include "model/numerics/continuation.h"
#include "surface3d/stationary/eigenmodes.h"
#include "surface3d/stationary/stationary.h"

#include <functional>
#include <memory>
#include <optional>

namespace sbeh::surface3d {

/// Of a branch: the state at μ.
struct PathSolution : StationaryState {
  double mu = 0;
  Nodes normals{};          ///< along which its nodes move
  Eigen::VectorXd phase{};  ///< of what has left a state with an axis: see Holds
};

/// With the unit tangent of its branch.
struct PathPoint : PathSolution {
  struct Direction : Increment {
    double mu = 0;
  };
  Direction tangent;
  int negative_directions =
      0;  ///< at fixed μ; one more or less beyond a fold, and beyond a branching point
  /// One behind on the same mesh, where it is known: predictions are of third order then, else of second.
  std::shared_ptr<const PathPoint> before{};
  double parameter() const { return mu; }
  double slope() const { return tangent.mu; }
};

/// Material and target as functions of μ, on one mesh, which must outlive this.
struct Path {
  using Solution = PathSolution;
  using Point = PathPoint;
  static constexpr model::ContinuationLimits limits{
      .most_iterations = 9, .tolerance = 1e-7, .far = 0.3, .fold = 1e-7};

  Path(const Triangulation& mesh, model::Model model,
       std::function<model::Material(double)> material, std::function<Target(double)> target);

  std::function<model::Material(double)> material;  ///< smooth
  std::function<Target(double)> target;
  std::shared_ptr<NewtonSystem> system;  ///< linearised at the state of the last call
};

// What model::ContinuationSystem asks for.
std::optional<PathSolution> predicted(const Path& path, const PathPoint& from, double ds);
std::optional<double> newton_step(const Path& path, PathSolution& x, const PathPoint& from,
                                  double ds);
/// Pointing as `forward`, or to growing μ without it.
std::optional<PathPoint> with_tangent(const Path& path, const PathSolution& x,
                                      const PathPoint::Direction* forward = nullptr);
bool continues(const Path& path, const PathPoint& from, const PathPoint& next, double ds);
using model::advance, model::arc_step, model::locate_fold;

/// The state at μ by Newton's method from a guess; empty where it fails.
std::optional<PathPoint> settled(const Path& path, const StationaryState& guess, double mu,
                                 const Eigen::VectorXd& phase = {});

/// The point `from` of the same branch on other triangles, from its surface on these, pointing the same way. Empty where Newton's
/// method fails or leads farther away than `near`, and where the state has an axis that its own path has left.
std::optional<PathPoint> on_other_triangles(const Path& path, const State& surface,
                                            const PathPoint& from, double near);

/// Where one or two eigenvalues that are negative at one of two points ds apart, and not at the other, are 0, no fold lying
/// between them: a branching point, with the modes that vanish there.
struct BranchingPoint {
  PathPoint at;
  std::vector<Eigenmode> modes;
};
/// Empty where it is not found.
std::optional<BranchingPoint> locate_branching(const Path& path, const PathPoint& before,
                                               const PathPoint& after, double ds);

/// The point of the branch that leaves along the first of the modes, `amplitude` away in the length of directions; < 0: the other way.
/// Empty where Newton's method fails, or leads to states that do not lead back there.
std::optional<PathPoint> switched(const Path& path, const BranchingPoint& from, double amplitude);

}  // namespace sbeh::surface3d
