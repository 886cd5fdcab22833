// What a scan costs, before it is run.
#pragma once

#include "studies/scan/scan_input.h"

namespace sbeh::studies {

/// Of one core of 2026, about.
double seconds_of(const ScanInput& input);

}  // namespace sbeh::studies
