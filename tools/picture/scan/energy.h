// The energy over time of a time-dependent scan, one panel per reduced volume.
#pragma once

#include "tools/picture/canvas/canvas.h"
#include "tools/picture/options.h"
#include "tools/picture/scan/scan_grid.h"

namespace sbeh::picture {

/// Writes DIR/energy.png and .svg if the scan has left histories.
void draw_energy_picture(Canvas& canvas, const ScanGrid& scan, const Options& options);

}  // namespace sbeh::picture
