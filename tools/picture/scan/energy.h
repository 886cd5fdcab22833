// The energy over time of a time-dependent scan, one panel per reduced volume.
#pragma once

#include "tools/picture/canvas/canvas.h"
#include "tools/picture/canvas/options.h"
#include "tools/picture/canvas/scan_table.h"

namespace sbeh::picture {

/// Writes DIR/energy.png and .svg if the scan has left histories.
void draw_energy_picture(Canvas& canvas, const ScanTable& scan, const Options& options);

}  // namespace sbeh::picture
