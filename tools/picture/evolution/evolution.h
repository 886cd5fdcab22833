// The pictures of one relaxation or 3D run, and of one mesh.
#pragma once

#include "tools/picture/canvas/canvas.h"
#include "tools/picture/options.h"

namespace sbeh::picture {

/// Writes DIR/energy.png and .svg from DIR/series.csv.
void draw_evolution_energy(Canvas& canvas, const Options& options);

/// Writes DIR/shapes.png and .svg from DIR/profiles.csv: up to eight cuts, coloured by the order.
void draw_relaxation_shapes(Canvas& canvas, const Options& options);

/// The same from DIR/frames.csv: up to ten frames, from above a side and along the axis, coloured by the order,
/// or by H where the order is uniform. Throws InputError.
void draw_run_shapes(Canvas& canvas, const Options& options);

/// A curved mesh, shaded and coloured by its order or its curvature, with its edges. Reads the VTU file
/// `options.directory` and writes a PNG beside it. Throws InputError.
void draw_mesh(Canvas& canvas, const Options& options);

}  // namespace sbeh::picture
