// The pictures of the modes of one state, each written into the folder of `sbeh modes`. All throw InputError.
#pragma once

#include "tools/picture/canvas/canvas.h"
#include "tools/picture/options.h"

namespace sbeh::picture {

/// profiles: the state in grey and, in the plane φ = 0, what the first mode of each m and parity makes of it, coloured by
/// the change of the order, or where that is fixed by the displacement.
void draw_mode_profiles(Canvas& canvas, const Options& options);

/// surfaces: the same in space.
void draw_mode_surfaces(Canvas& canvas, const Options& options);

/// contour: the spectrum of the contour's fluctuations, from contour.csv; nothing where there is none.
void draw_contour_spectrum(Canvas& canvas, const Options& options);

}  // namespace sbeh::picture
