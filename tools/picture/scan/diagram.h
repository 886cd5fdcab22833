// The diagram of a scan: energy gap, smallest order and largest curvature over (reduced volume, L).
#pragma once

#include "tools/picture/canvas/canvas.h"
#include "tools/picture/options.h"
#include "tools/picture/scan/scan_grid.h"

namespace sbeh::picture {

/// Writes DIR/diagram.png and .svg: cells, or curves if only one of the two parameters varies.
void draw_diagram_picture(Canvas& canvas, const ScanGrid& scan, const Options& options);

}  // namespace sbeh::picture
