// Contour lines of values on a grid with gaps.
#pragma once

#include "tools/picture/canvas/geometry.h"

#include <vector>

namespace sbeh::picture {

/// values[i][j] at (x[i], y[j]), NaN where there is none; only cells with four values have contours.
std::vector<Points> contour_lines(const std::vector<double>& x, const std::vector<double>& y,
                                  const std::vector<std::vector<double>>& values, double level);

}  // namespace sbeh::picture
