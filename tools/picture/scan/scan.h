// The pictures of a scan; each is written as PNG and SVG into the scan's folder.
#pragma once

#include "tools/picture/canvas/canvas.h"
#include "tools/picture/options.h"
#include "tools/picture/scan/scan_grid.h"

namespace sbeh::picture {

/// diagram: energy gap, smallest order and largest curvature over (reduced volume, L), as cells, or as
/// curves if only one of the two varies.
void draw_diagram_picture(Canvas& canvas, const ScanGrid& scan, const Options& options);
void draw_line_diagram(Canvas& canvas, const ScanGrid& scan, const Options& options);

/// cuts: the cross sections, a matrix over reduced volume and L, and all L in one panel. Says in a sentence
/// what is missing.
void draw_cuts_picture(Canvas& canvas, const ScanGrid& scan, const Options& options);

/// energy: over time, one panel per reduced volume, if the scan has left histories.
void draw_energy_picture(Canvas& canvas, const ScanGrid& scan, const Options& options);

}  // namespace sbeh::picture
