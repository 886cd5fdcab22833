// Where curves cross the lines of a grid, joined to these curves.
#pragma once

#include "tools/picture/canvas/geometry.h"

#include <cstddef>
#include <vector>

namespace sbeh::picture {

/// The indices of the crossings along each open chain. A place counts lines of the grid, at least one of its two numbers
/// being whole. Two crossings are joined where they are the only ones on the border of a cell, and on different sides
/// of it: with more it cannot be said which belong together, and two on one side are two curves or one that turns back.
std::vector<std::vector<std::size_t>> chains(const Points& crossings);

}  // namespace sbeh::picture
