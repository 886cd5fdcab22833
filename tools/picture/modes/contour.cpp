#include "studies/modes/modes.h"
#include "tools/picture/chart/chart.h"
#include "tools/picture/modes/modes.h"

#include <fmt/format.h>

#include <cmath>

namespace sbeh::picture {

void draw_contour_spectrum(Canvas& canvas, const Options& options) {
  const std::filesystem::path table = options.directory / "contour.csv";
  if (!std::filesystem::exists(table)) return;
  Points points;
  Range values;
  for (const studies::ContourRow& row : studies::read_rows(studies::contour_columns(), table)) {
    if (row.m < 2 || !std::isfinite(row.spectrum)) continue;  // 0 and 1: the size and the place
    points.push_back({std::log10(double(row.m)),
                      std::log10(options.factor(studies::dimension::area) * row.spectrum)});
    values.include(points.back()[1]);
  }
  if (points.size() < 2) {
    fmt::print("no contour: {} has no two values to draw\n", table.string());
    return;
  }
  if (options.units && !options.units->other_temperature().empty())
    fmt::print("contour: {}\n", options.units->other_temperature());
  const double text = options.text_size();
  const double width = options.width(900.0), height = options.height(700.0);
  canvas.start(width, height, options.unit());
  const double below = below_axis(text) + 0.6 * text;
  const Rect inside{6.4 * text, below, width - 8.0 * text, height - below - 1.4 * text};
  Chart chart(canvas, inside, text,
              decade_axis(std::log10(1.8), points.back()[0] + 0.04, "m of the contour"),
              decade_axis(values.low - 0.1, values.high + 0.1,
                          options.titled("mean square ⟨|cₘ|²⟩", studies::dimension::area)));
  chart.curve(points, {.colour = {0, 84, 159}, .width = 2.0});
  chart.markers(points, Marker::circle, {0, 84, 159}, 0.5 * text);
  canvas.write(options.directory / "contour", options.output());
}

}  // namespace sbeh::picture
