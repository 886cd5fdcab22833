// The classical diagram: reduced energy over reduced volume of the branches that `sbeh seifert` found.
#pragma once

#include "tools/picture/options.h"

namespace sbeh::picture {

class Canvas;

/// From branches.csv and points.csv: curves of the first witness, the others as marks on them, and the
/// special points. Throws InputError.
void draw_classical_diagram(Canvas& canvas, const Options& options);

}  // namespace sbeh::picture
