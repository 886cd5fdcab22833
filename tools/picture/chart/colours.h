// Colours for values: perceptually uniform maps, readable without colour vision, and their bar.
#pragma once

#include "tools/picture/chart/chart.h"
#include "tools/picture/options.h"

#include <string>
#include <vector>

namespace sbeh::picture {

class ColourMap {
 public:
  /// For values in a range; one of no width is widened. Shaded surfaces with dark edges want a share of white.
  /// `factor`: what values are multiplied by to be in the range.
  ColourMap(Palette palette, const Range& range, double white_share = 0.0, double factor = 1.0);

  /// The range and the ticks of the bar.
  const Axis& scale() const { return scale_; }
  Colour operator()(double value) const { return at(scale_.share(factor_ * value)); }
  Colour at(double share) const;  ///< 0 at the lower end, 1 at the upper one

 private:
  Axis scale_;
  double factor_;
  std::vector<Colour> table_;  // at equal distances over the range
};

inline constexpr double white_on_surfaces = 0.22;

/// For data of the tables, in the palette, scale and units that the user asks for.
ColourMap chosen_colours(const Options& options, Palette usual, const Range& data,
                         double white_share = 0.0, const studies::Dimension& dimension = {});

/// The bar fills `rect`; its numbers and then its title stand to the right, this as long as the bar or the room.
void draw_colour_bar(Canvas& canvas, const Rect& rect, const ColourMap& map,
                     const std::string& title, double text_size, double title_room = 0.0);

/// A bar with its left side at `x`, in the middle of the room from below to above, at most 18 letters high.
void draw_short_bar(Canvas& canvas, double x, const Range& room, const ColourMap& map,
                    const std::string& title, double text_size);

/// Width of the numbers and the title beside a bar.
double colour_bar_margin(const Canvas& canvas, const ColourMap& map, bool title, double text_size);

/// `count` colours in order, well apart, dark for the last, for lines on white.
std::vector<Colour> line_colours(std::size_t count);

/// Black or white, whichever is legible on the colour.
Colour ink_on(Colour background);

}  // namespace sbeh::picture
