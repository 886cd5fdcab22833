// A quantity over (reduced volume, L) as coloured cells with their colour bar.
#pragma once

#include "tools/picture/chart/legend.h"
#include "tools/picture/scan/quantity.h"

namespace sbeh::picture {

struct HeatMapGrid {
  GridAxis x{};          ///< reduced volume
  GridAxis y{};          ///< L
  bool as_table = true;  ///< few points: numbers in the cells; otherwise contour lines
};

/// `inside` is the rectangle of the cells; the bar stands `0.8 text_size` to its right.
void draw_heat_map(Canvas& canvas, const Rect& inside, const Quantity& quantity,
                   const ColourMap& colours, const HeatMapGrid& grid, double text_size);

/// A colour per branch, and no bar.
void draw_branch_map(Canvas& canvas, const Rect& inside, const BranchMap& map,
                     const HeatMapGrid& grid, double text_size);
/// The colours of the branches that are there.
std::vector<LegendEntry> branch_legend(const BranchMap& map);

/// Legend of the marks in use.
std::vector<LegendEntry> mark_legend(const std::vector<Quantity>& quantities, bool as_table);

}  // namespace sbeh::picture
