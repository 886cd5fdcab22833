// Following a branch of stationary states through the (V_r, L) plane, up to and including its fold.
#pragma once

#include "axisym/stationary/line.h"
#include "axisym/stationary/stationary.h"

#include <optional>

namespace sbeh::axisym {

/// A stationary state at its point of the plane.
struct BranchState : StationaryState {
  PlanePoint at{};
  int determinant_sign = 0;  ///< flips where another branch crosses, and at a fold
};

// Functions of a material and a PlanePoint take the material but for L.

/// Newton's method at a point, from a guess; empty unless it converges.
std::optional<BranchState> solve_at(const model::Material& material, model::Model model,
                                    PlanePoint at, const StationaryState& guess,
                                    const NewtonOptions& options = {});

enum class Arrival {
  reached,  ///< `state` is at the point asked for
  fold,     ///< the branch ends in a fold before it; `state` is at the fold
  neck,     ///< a neck closes before it: `state` is the first where it is seen to
  lost      ///< Newton failed for another reason; `state` is the last good one
};

struct FollowResult {
  Arrival arrival;
  BranchState state;
  Line line;             ///< that was followed
  double mu;             ///< of the state
  BranchState before{};  ///< of a fold: the last state before it
};

/// Moves a stationary state along a line, from μ = 0 to 1: one Newton solve from the tangent's
/// prediction where that stays on the branch (few iterations, same sign of the determinant),
/// otherwise pseudo-arclength steps, which see a fold where the parameter turns back and locate it.
/// Nodes are redistributed on arrival. Bounded work: a few hundred Newton iterations at the most.
FollowResult follow(const Line& line, const BranchState& from, const Numerics& numerics);
/// Along the straight line to `to` in this material.
FollowResult follow(const model::Material& material, model::Model model, const BranchState& from,
                    PlanePoint to, const Numerics& numerics);

}  // namespace sbeh::axisym
