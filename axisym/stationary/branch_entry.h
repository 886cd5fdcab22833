// The first state of a branch, from which the others are followed.
#pragma once

#include "axisym/classical_shape.h"
#include "axisym/stationary/continuation.h"

#include <optional>

namespace sbeh::axisym {

/// The reduced volume at which oblates and prolates are entered from spheroids.
inline constexpr double entry_volume = 0.95;

/// Where a branch of SSH begins.
struct BranchEntry {
  BranchState state;                     ///< to go on from
  std::optional<BranchState> pitchfork;  ///< stomatocytes: the oblate they leave
  std::optional<BranchState> fold;       ///< stomatocytes: their largest reduced volume
};

/// SSH's oblate or prolate at entry_volume, from the spheroid; or a stable stomatocyte near the fold of
/// its branch, which is followed from the oblates' pitchfork. Empty when Newton's method loses the way
/// (possible with a residual stiffness or a spontaneous curvature).
std::optional<BranchEntry> enter_branch(Branch branch, const model::Material& material,
                                        const Numerics& numerics);

/// Stomatocytes from an oblate between the pitchfork and V_r of about 0.6.
std::optional<BranchEntry> enter_stomatocytes(const BranchState& oblate,
                                              const model::Material& material,
                                              const Numerics& numerics);

}  // namespace sbeh::axisym
