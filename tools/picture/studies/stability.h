// Which axisymmetric states are stable in 3D: markers over (V_r, L), or rates over V_r where there is one L.
#pragma once

#include "tools/picture/canvas/canvas.h"
#include "tools/picture/options.h"

namespace sbeh::picture {

/// Writes DIR/stability.png and .svg from DIR/stability.csv.
void draw_stability(Canvas& canvas, const Options& options);

}  // namespace sbeh::picture
