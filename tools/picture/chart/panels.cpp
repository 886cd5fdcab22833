#include "tools/picture/chart/panels.h"

#include <algorithm>

namespace sbeh::picture {
namespace {

constexpr double flattest = 0.62;  // height over width in rows

double inner_width(const PanelNeeds& needs, double width, std::size_t columns) {
  return (width - needs.side) / double(columns) - needs.left - needs.right;
}

}  // namespace

Rect PanelGrid::inside(std::size_t panel) const {
  const std::size_t row_index = panel / columns;
  const auto column = double(panel % columns), row = double(row_index);
  const double x = needs.side + column * (needs.left + inner_width + needs.right) + needs.left,
               y = height - needs.top - (row + 1.0) * (needs.above + inner_height + needs.below)
                 + needs.below;
  return {x, y, inner_width, inner_height};
}

PanelGrid arranged(const PanelNeeds& needs, const Options& options) {
  PanelGrid grid{.needs = needs};
  const std::size_t most = std::min(needs.count, needs.most_columns);
  grid.width = options.width(std::max(needs.usual_width * double(most), needs.least_picture));
  grid.columns = most;
  while (grid.columns > 1 && inner_width(needs, grid.width, grid.columns) < needs.least_width)
    --grid.columns;
  grid.rows = (needs.count + grid.columns - 1) / grid.columns;
  grid.inner_width = inner_width(needs, grid.width, grid.columns);
  const double height_by_width =
      grid.columns < most ? std::min(flattest, needs.height_by_width) : needs.height_by_width;
  const double fixed = needs.bottom + needs.top + double(grid.rows) * (needs.below + needs.above);
  grid.height = options.height(fixed + double(grid.rows) * height_by_width * grid.inner_width);
  grid.inner_height = (grid.height - fixed) / double(grid.rows);
  return grid;
}

}  // namespace sbeh::picture
