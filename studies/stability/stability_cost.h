// What a study of stability will cost, before it runs.
#pragma once

#include "studies/stability/stability_input.h"

namespace sbeh::studies {

struct StabilityCost {
  int runs = 0;
  double steps = 0;    ///< of all runs
  double seconds = 0;  ///< of one core, as measured on one of 2026
};

/// A run lasts until its mode has decayed to a fifth, or has grown and come to rest elsewhere: as long as the largest
/// rate of the linearised flow says, of its m and its parity, at the most until the end time. Of many runs
/// some are looked at, evenly spread.
StabilityCost cost_of(const StabilityInput& input);

}  // namespace sbeh::studies
