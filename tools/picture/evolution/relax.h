// The pictures of one relaxation: its energy over time and its shapes at some times.
#pragma once

#include "tools/picture/canvas/canvas.h"
#include "tools/picture/options.h"

namespace sbeh::picture {

/// Writes DIR/energy.png and .svg from DIR/series.csv.
void draw_relaxation_energy(Canvas& canvas, const Options& options);

/// Writes DIR/shapes.png and .svg from DIR/profiles.csv.
void draw_relaxation_shapes(Canvas& canvas, const Options& options);

}  // namespace sbeh::picture
