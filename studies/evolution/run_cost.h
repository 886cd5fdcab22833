// What a 3D run costs, before it is run.
#pragma once

#include "studies/evolution/run_start.h"

namespace sbeh::studies {

/// Seconds and MB as measured with the defaults on one core of 2026; good to a factor of two.
struct RunCost {
  int unknowns;  ///< of the linear system of the flow: V, p, H, and with Y where monolithic
  double seconds_per_step;  ///< of the two-step method; step doubling takes three times that
  double megabytes;
  double frame_megabytes;  ///< of one file
};

/// Of a run on a surface with so many triangles (V − E + F = 2).
RunCost cost_of(const RunInput& input, int triangles);

}  // namespace sbeh::studies
