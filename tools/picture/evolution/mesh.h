// The picture of a curved mesh: shaded and coloured by its order or its curvature, with its edges.
#pragma once

#include "tools/picture/canvas/canvas.h"
#include "tools/picture/options.h"

namespace sbeh::picture {

/// Reads the VTU file `options.directory` and writes a PNG beside it. Throws InputError.
void draw_mesh(Canvas& canvas, const Options& options);

}  // namespace sbeh::picture
