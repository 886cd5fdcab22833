// Steps along a branch of stationary states, parametrised by its own length, so that folds are no
// obstacle.
#pragma once

#include "axisym/stationary/continuation.h"
#include "axisym/stationary/newton_system.h"

#include <optional>

namespace sbeh::axisym {

/// Nodes: B_φφ², 1 at least. In a neck a displacement counts as long as it is against the neck's radius, which
/// does not become a fraction in one step.
Field weights_of(const StationaryState& state);

/// Length of a direction: root mean square of weighted motion and of order, and μ.
double length_of(const Increment& t, const Field& weights);

/// With its tangent of unit length.
struct PathState : LineState {
  Increment tangent;
  Field weights;  ///< of lengths here
  int determinant_sign;

  double parameter() const { return mu; }
  double slope() const { return tangent.mu; }
};

Increment scaled(Increment t, double factor);

/// The state with its tangent, pointing the way of `forward`, or of growing μ without it. Empty where
/// the matrix is singular.
std::optional<PathState> with_tangent(const Line& line, const LineState& state,
                                      const Increment* forward = nullptr);

/// The largest change that Newton's method may make to a prediction by a tangent: where it is of the prediction's own
/// size the branch bends, and what is found may be another part of it, beyond two folds.
double largest_correction(double predicted_change);

// What model::ContinuationSystem asks for.
std::optional<LineState> predicted(const Line& line, const PathState& from, double ds);
std::optional<double> newton_step(const Line& line, LineState& state, const PathState& from,
                                  double ds);
bool continues(const Line& line, const PathState& from, const PathState& next, double ds);
using model::advance, model::arc_step, model::locate_fold;

/// Redistributes the nodes of a state on the path, over as many elements as `elements_for` says, and solves
/// again; the state itself where that fails. Keeps the direction of the tangent.
PathState with_fresh_nodes(const Line& line, const PathState& state, const Numerics& numerics);

/// The path's state near a guess on other nodes, at a μ near its own. Empty where Newton's method fails.
std::optional<PathState> on_nodes(const Line& line, LineState guess);
/// With its tangent pointing the way of that of `state`, at a μ near which it is.
std::optional<PathState> on_nodes(const Line& line, const PathState& state, StationaryState guess);

}  // namespace sbeh::axisym
