// The names of the colours for values, and what is drawn in which.
#pragma once

#include "model/names.h"

#include <array>

namespace sbeh::picture {

/// All dark for small values and light for large ones.
enum class Palette { viridis, cividis, magma, grey };
constexpr auto names(Palette) { return std::array{"viridis", "cividis", "magma", "grey"}; }

/// On lines, areas and surfaces alike.
inline constexpr Palette order_palette = Palette::viridis, curvature_palette = Palette::magma,
                         energy_palette = Palette::cividis;

}  // namespace sbeh::picture
