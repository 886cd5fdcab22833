// Following a branch of stationary states through the (V_r, L) plane, up to and including its fold.
#pragma once

#include "axisym/options.h"
#include "axisym/stationary/stationary.h"

namespace sbeh::axisym {

/// Where a state belongs: reduced volume and elastic constant of the one-constant approximation.
struct PlanePoint {
  double reduced_volume;
  double L;
};

/// A stationary state at its parameters.
struct BranchState {
  PlanePoint at;
  StationaryState solution;
  int determinant_sign = 0;  ///< flips where another branch crosses, and at a fold
  int iterations = 0;        ///< of Newton, all that led here from the last state
};

enum class Arrival {
  reached,  ///< `state` is at the point asked for
  fold,     ///< the branch ends in a fold before it; `state` is at the fold
  lost      ///< Newton failed for another reason; `state` is the last good one
};

struct FollowResult {
  Arrival arrival;
  BranchState state;
};

/// The target of a stationary state: A = 4π and the volume of this reduced volume.
Target target_of(double reduced_volume);

/// Moves a stationary state along the straight line to `to`: one Newton solve from the tangent's
/// prediction where that stays on the branch (few iterations, same sign of the determinant),
/// otherwise pseudo-arclength steps, which see a fold where the parameter turns back and locate it.
/// Nodes are redistributed on arrival. Bounded work: a few hundred Newton iterations at the most.
FollowResult follow(const model::Material& material, model::Model model, const BranchState& from,
                    PlanePoint to, const Numerics& numerics);

}  // namespace sbeh::axisym
