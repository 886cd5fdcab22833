// The cross sections of a scan: a matrix over reduced volume and L, and all L in one panel.
#pragma once

#include "tools/picture/canvas/canvas.h"
#include "tools/picture/canvas/options.h"
#include "tools/picture/canvas/scan_table.h"

namespace sbeh::picture {

/// Writes DIR/cuts.png and .svg; says in a sentence what is missing.
void draw_cuts_picture(Canvas& canvas, const ScanTable& scan, const Options& options);

}  // namespace sbeh::picture
