// Following a branch of stationary states through the (V_r, L) plane, up to and including its fold.
#pragma once

#include "axisym/stationary/stationary.h"
#include "axisym/stationary/stationary_case.h"

#include <optional>

namespace sbeh::axisym {

/// A stationary state at its point of the plane.
struct BranchState : StationaryState {
  PlanePoint at{};
  int determinant_sign = 0;  ///< flips where another branch crosses, and at a fold
  /// Of the last Newton solve: where `follow` arrives that of the redistributed state, 0 if it failed. At a
  /// fold the number of arc steps before it.
  int iterations = 0;
};

// Functions of a material and a PlanePoint take the material but for L.

/// Newton's method at a point, from a guess; empty unless it converges.
std::optional<BranchState> solve_at(const model::Material& material, model::Model model,
                                    PlanePoint at, const StationaryState& guess,
                                    const NewtonOptions& options = {});

/// A radius: a neck that is thinner tends to a point between two closed surfaces.
inline constexpr double closed_neck = 0.005;

enum class Arrival {
  reached,  ///< `state` is at the point asked for
  fold,     ///< the branch ends in a fold before it; `state` is at the fold
  neck,     ///< a neck closes before it: `state` is the first where it is thinner than closed_neck
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
