// The ways on which a scan comes to its points.
#pragma once

#include "studies/scan/scan_folder.h"

namespace sbeh::studies {

/// Computes the points that are not there yet, by the method of the scan and in parallel. Incomplete when interrupted.
void compute_points(Scan& scan);

}  // namespace sbeh::studies
