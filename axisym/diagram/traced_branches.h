// The branches that leave the sphere, and what leaves these, traced as far as they go.
#pragma once

#include "axisym/diagram/trace.h"

#include <optional>
#include <string>
#include <vector>

namespace sbeh::axisym {

/// The V_r at which lines begin on which oblates and prolates are found near the sphere.
inline constexpr double nearly_round = 0.99;

/// How near to a loss of symmetry the last state is of a branch that comes back there, in V_r.
inline constexpr double near_return = 0.01;

struct TracedBranch {
  std::string
      name;  ///< oblate, prolate; pear of what leaves a prolate, stomatocyte an oblate; further ones with a number
  std::string from;     ///< that it leaves, empty where it comes from the sphere
  double start_volume;  ///< V_r where it leaves; of those from the sphere where it is entered
  std::optional<double>
      end_volume;  ///< within near_return of which it comes back to a symmetric shape
  Line line;
  Trace trace;
};

/// The prolates and oblates of SSH along a line from V_r = nearly_round; those that Newton's method finds there.
std::vector<TracedBranch> traced_from_sphere(Line line, const Numerics& numerics,
                                             const TraceOptions& options);

/// Adds what leaves the symmetric ones among them, not symmetric top to bottom; a branch that comes back to one leaves it once.
void add_leaving(std::vector<TracedBranch>& branches, const Numerics& numerics,
                 const TraceOptions& options);

}  // namespace sbeh::axisym
