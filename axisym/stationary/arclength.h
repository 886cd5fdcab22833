// Steps along a branch of stationary states, parametrised by its own length, so that folds are no
// obstacle.
#pragma once

#include "axisym/stationary/continuation.h"
#include "axisym/stationary/newton_system.h"
#include "model/numerics/continuation.h"

#include <optional>

namespace sbeh::axisym {

/// A state on a line.
struct LineState : StationaryState {
  double mu = 0;
};

/// With its tangent of unit length (root mean square of displacement and order, and μ).
struct PathState : LineState {
  Increment tangent;
  int determinant_sign;

  double slope() const { return tangent.mu; }
};

/// A straight line through the (V_r, L) plane, μ = 0 at `from`, 1 at `to`, and beyond both.
struct Line {
  using Solution = LineState;
  using Point = PathState;
  static constexpr model::ContinuationLimits limits{
      .most_iterations = 9, .tolerance = 1e-6, .far = 0.3, .fold = 1e-8};

  model::Material material;  ///< but for L
  model::Model model;
  PlanePoint from, to;

  PlanePoint at(double mu) const;
  Target target(double mu) const { return target_of(at(mu).reduced_volume); }
  model::Material material_at(double mu) const { return material.with_L(at(mu).L); }
  /// Whether there are states to look for: V_r <= 1, L > 0.
  bool contains(double mu) const { return at(mu).L > 0 && at(mu).reduced_volume <= 1; }

  double volume_rate() const { return target(1).volume - target(0).volume; }
  Eigen::VectorXd gradient_rate(const LineState& state) const;
};

/// Length of a direction: root mean square of motion and order, and μ.
double length_of(const Increment& t);
Increment scaled(Increment t, double factor);

/// Largest displacement or change of order in a step.
double largest_change(const Increment& step);

/// The state with its tangent, pointing the way of `forward`, or of growing μ without it. Empty where
/// the matrix is singular.
std::optional<PathState> with_tangent(const Line& line, const LineState& state,
                                      const Increment* forward = nullptr);

// What model::ContinuationSystem asks for.
std::optional<LineState> predicted(const Line& line, const PathState& from, double ds);
std::optional<double> newton_step(const Line& line, LineState& state, const PathState& from,
                                  double ds);
double cosine(const PathState& a, const PathState& b);
using model::advance, model::arc_step, model::locate_fold;

/// Redistributes the nodes of a state on the path and solves again; the state itself where that
/// fails. Keeps the direction of the tangent.
PathState with_fresh_nodes(const Line& line, const PathState& state, double grading);

}  // namespace sbeh::axisym
