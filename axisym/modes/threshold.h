// Where along a branch the lowest eigenvalue of an m and a parity changes its sign.
#pragma once

#include "axisym/modes/eigenmodes.h"
#include "axisym/stationary/arclength.h"

#include <span>
#include <vector>

namespace sbeh::axisym {

/// The estimated error, in V_r or L, within which a threshold is located unless less is asked for.
inline constexpr double promised_threshold = 1e-7;

struct Threshold {
  int m;
  Parity parity;
  BranchState state;  ///< there, over as many elements as that needs
  /// Estimated, of the coordinate in which the line goes: a sixteenth of what half as many elements give differently,
  /// or the change over which the eigenvalue is nearer to zero than what rigid motions leave. Infinite where the
  /// branch was lost on the way.
  double error;
  bool is_located;  ///< within the error that was asked for
};

/// The threshold between a state on a path and the one ds further, where the eigenvalue has the other sign. Elements
/// are doubled (to most_elements at the most) until the error is as promised.
Threshold threshold_within(const Line& line, const PathState& from, double ds, int m, Parity parity,
                           const Numerics& numerics, double promised = promised_threshold);

/// What is looked for along the branch: eigenvalues with different signs at the ends of a step, or those with one sign at
/// both ends and the other between them, which makes two thresholds.
enum class Search { changes, turns };

/// Those of these m between a stationary state at μ = 0 and μ = 1, or the fold before that, which is none of them
/// itself.
std::vector<Threshold> thresholds_along(const Line& line, const StationaryState& from,
                                        std::span<const int> ms, const Numerics& numerics,
                                        double promised = promised_threshold,
                                        Search search = Search::changes);

}  // namespace sbeh::axisym
