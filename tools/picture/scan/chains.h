// Points that lie on curves, in no order, joined to these.
#pragma once

#include "tools/picture/canvas/geometry.h"

#include <cstddef>
#include <functional>
#include <vector>

namespace sbeh::picture {

/// The nearest are joined first, each point to two others at the most, none farther than `farthest`; the indices of the
/// points along each open chain. `may_join`: whether two of these points can be neighbours.
std::vector<std::vector<std::size_t>> chains(
    const Points& points, double farthest,
    const std::function<bool(std::size_t, std::size_t)>& may_join = {});

}  // namespace sbeh::picture
