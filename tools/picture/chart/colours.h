// Colours for values: perceptually uniform maps, readable without colour vision, and their bar.
#pragma once

#include "tools/picture/chart/chart.h"

#include <string>
#include <vector>

namespace sbeh::picture {

enum class Palette {
  viridis,   ///< dark for small values: for areas
  lines,     ///< light for small values, without the palest: for lines on white
  surfaces,  ///< viridis with some white: for shaded surfaces with dark edges
  plain      ///< one light grey: for shaded surfaces without a quantity
};

class ColourMap {
 public:
  /// For values in a range; one of no width is widened.
  ColourMap(Palette palette, const Range& range);

  /// The range and the ticks of the bar.
  const Axis& scale() const { return scale_; }
  Colour operator()(double value) const;

 private:
  Axis scale_;
  std::vector<Colour> table_;  // at equal distances over the range
};

/// The bar fills `rect`; its numbers and then its title stand to the right.
void draw_colour_bar(Canvas& canvas, const Rect& rect, const ColourMap& map,
                     const std::string& title, double text_size);

/// A bar with its left side at `x`, in the middle of the room from below to above, at most 18 letters high.
void draw_short_bar(Canvas& canvas, double x, const Range& room, const ColourMap& map,
                    const std::string& title, double text_size);

/// Width of the numbers and the title beside a bar.
double colour_bar_margin(const Canvas& canvas, const ColourMap& map, bool title, double text_size);

/// `count` colours in order, well apart, for lines on white.
std::vector<Colour> line_colours(std::size_t count);

/// Black or white, whichever is legible on the colour.
Colour ink_on(Colour background);

}  // namespace sbeh::picture
