// Cross sections in equal cells of one scale: what the pictures of a scan and of a run share.
#pragma once

#include "tools/picture/chart/colours.h"
#include "tools/picture/section/cut.h"

#include <vector>

namespace sbeh::picture {

/// The largest half width and half height of all cuts shown together.
struct Extent {
  double half_width = 0.0;
  double half_height = 0.0;
  void include(const Cut& cut);
};

/// The range of β over cuts, for the colours.
struct OrderRange {
  double low = 1.0;
  double high = 0.0;
  void include(const Cut& cut);
  ColourMap colours() const;
};

/// One cut in a cell: coloured by its order if `colours` is set, otherwise as `style` says.
struct CutLine {
  const Cut* cut = nullptr;
  const ColourMap* colours = nullptr;
  LineStyle style;
};

/// Centred in the cell, `scale` pixels per unit of length in both directions.
void draw_cuts(Canvas& canvas, const Rect& cell, double scale, const std::vector<CutLine>& lines);

}  // namespace sbeh::picture
