// The cross sections of a scan: a matrix over reduced volume and L, and all L in one panel.
#pragma once

#include "tools/picture/canvas/canvas.h"
#include "tools/picture/options.h"
#include "tools/picture/scan/scan_grid.h"

namespace sbeh::picture {

/// Writes DIR/cuts.png and .svg; says in a sentence what is missing.
void draw_cuts_picture(Canvas& canvas, const ScanGrid& scan, const Options& options);

}  // namespace sbeh::picture
