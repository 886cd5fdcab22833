// Contour lines of a quantity that is known in the middle of cells.
#pragma once

#include "tools/picture/canvas/geometry.h"
#include "tools/picture/chart/axis.h"

#include <vector>

namespace sbeh::picture {

/// Up to the edges of the cells that have a value, where it is interpolated between neighbours, or goes on as between
/// the two cells before. values[i][j]: NaN where there is none. Points in the coordinates of the axes.
std::vector<Points> contours_of_cells(const GridAxis& x, const GridAxis& y,
                                      const std::vector<std::vector<double>>& values, double level);

}  // namespace sbeh::picture
