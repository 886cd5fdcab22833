#include "tools/picture/section/panels.h"

#include "tools/picture/chart/chart.h"

#include <algorithm>
#include <cmath>

namespace sbeh::picture {

void Extent::include(const Cut& cut) {
  half_width = std::max(half_width, cut.half_width);
  half_height = std::max(half_height, cut.half_height);
}

void OrderRange::include(const Cut& cut) {
  for (const double order : cut.order) {
    if (!std::isfinite(order)) continue;
    low = std::min(low, order);
    high = std::max(high, order);
  }
}

ColourMap OrderRange::colours() const {
  return high > low ? ColourMap(Palette::lines, low, high) : ColourMap(Palette::lines, 0.0, 1.0);
}

void draw_cuts(Canvas& canvas, const Rect& cell, double scale, const std::vector<CutLine>& lines) {
  constexpr double point_distance = 3.0;  // pixels
  const double x = 0.5 * cell.width / scale;
  const double y = 0.5 * cell.height / scale;
  Chart chart(canvas, cell, 1.0, {.low = -x, .high = x, .title = {}, .ticks = {}, .labels = {}},
              {.low = -y, .high = y, .title = {}, .ticks = {}, .labels = {}});
  for (const CutLine& line : lines) {
    const Cut cut = thinned(*line.cut, point_distance / scale);
    if (!line.colours) {
      chart.curve(cut.points, line.style);
      continue;
    }
    std::vector<Colour> colours;
    for (const double order : cut.order) {
      colours.push_back(std::isfinite(order) ? (*line.colours)(order) : dark_grey);
    }
    chart.coloured_curve(cut.points, colours, line.style.width);
  }
}

}  // namespace sbeh::picture
