// The pictures of one 3D run: shapes over time.
#pragma once

#include "tools/picture/canvas/canvas.h"
#include "tools/picture/options.h"

namespace sbeh::picture {

/// DIR/shapes.png from DIR/frames.csv: up to ten frames, from above a side and along the axis, coloured
/// by the order, or by H where the order is uniform. Throws InputError.
void draw_run_shapes(Canvas& canvas, const Options& options);

}  // namespace sbeh::picture
