// The profiles that `sbeh compare` found, on top of each other, and their distances.
#pragma once

#include "tools/picture/options.h"

namespace sbeh::picture {

class Canvas;

/// From profiles.csv: cross sections of all methods, the 3D solver's nodes as marks, and below them the
/// distance from the first method over the arc length. Writes DIR/profiles.png and .svg. Throws InputError.
void draw_compared_profiles(Canvas& canvas, const Options& options);

}  // namespace sbeh::picture
