// A legend in one or more centred lines: samples with their meaning.
#pragma once

#include "tools/picture/chart/chart.h"
#include "tools/picture/chart/colours.h"

#include <functional>
#include <string>
#include <vector>

namespace sbeh::picture {

struct LegendEntry {
  std::function<void(Canvas&, const Rect&)> sample;  ///< draws into the rectangle
  std::string text;
};

LegendEntry line_entry(const LineStyle& style, std::string text);
LegendEntry coloured_line_entry(const ColourMap& map, double width, std::string text);

LegendEntry marker_entry(Marker marker, Colour colour, std::string text);

/// The height it takes when at most `width` wide.
double legend_height(const Canvas& canvas, const std::vector<LegendEntry>& entries, double width,
                     double text_size);

/// `place` is filled from its top.
void draw_legend(Canvas& canvas, const std::vector<LegendEntry>& entries, const Rect& place,
                 double text_size);

}  // namespace sbeh::picture
