// The diagram of a scan in which only the reduced volume or only L varies: curves.
#pragma once

#include "tools/picture/canvas/canvas.h"
#include "tools/picture/options.h"
#include "tools/picture/scan/scan_grid.h"

namespace sbeh::picture {

/// Writes DIR/diagram.png and .svg.
void draw_line_diagram(Canvas& canvas, const ScanGrid& scan, const Options& options);

}  // namespace sbeh::picture
