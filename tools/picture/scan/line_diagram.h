// The diagram of a scan in which only the reduced volume or only L varies: curves.
#pragma once

#include "tools/picture/canvas/canvas.h"
#include "tools/picture/canvas/options.h"
#include "tools/picture/canvas/scan_table.h"

namespace sbeh::picture {

/// Writes DIR/diagram.png and .svg.
void draw_line_diagram(Canvas& canvas, const ScanTable& scan, const Options& options);

}  // namespace sbeh::picture
