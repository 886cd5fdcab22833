// Closed cross sections of axisymmetric shapes, and how they are drawn: in cells of one scale.
#pragma once

#include "axisym/curve.h"
#include "tools/picture/chart/colours.h"
#include "tools/picture/options.h"

#include <string>
#include <vector>

namespace sbeh::picture {

/// The cross section in a plane through the axis: closed (first point = last point) and centred in z.
struct Cut {
  Points points;                  ///< (±r, z)
  std::vector<double> order;      ///< β at each point
  std::vector<double> curvature;  ///< H there; may be empty
  double half_width = 0.0;
  double half_height = 0.0;
};

/// Of the P3 elements of a state; or of points that are none, then without H.
Cut mirrored(const axisym::State& profile);

/// Only the points a picture can show: those farther apart than `spacing`, or where the curve turns.
Cut thinned(const Cut& cut, double spacing);

/// The largest half width and half height of all cuts shown together.
struct Extent {
  double half_width = 0.0;
  double half_height = 0.0;
  void include(const Cut& cut);
};

/// Of β and H over cuts that are shown together.
struct FieldRanges {
  Range order, curvature;
  void include(const Cut& cut);
};

/// How cuts are coloured: by their order; by their mean curvature where the order is uniform, unless options say
/// otherwise.
struct CutColours {
  Field field;
  ColourMap map;
  std::string title;
  const std::vector<double>& values(const Cut& cut) const {
    return field == Field::order ? cut.order : cut.curvature;
  }
};
CutColours colours_for(const FieldRanges& ranges, const Options& options);

/// Of the lines of coloured cuts.
inline constexpr double coloured_width = 6.4;

/// One cut in a cell: coloured by a field if `colours` is set, otherwise as `style` says.
struct CutLine {
  const Cut* cut = nullptr;
  const CutColours* colours = nullptr;
  LineStyle style{};
};

/// Of the cut number `length` of `count` at ascending L: grey and thin at first, black and thicker at last.
LineStyle style_by_length(std::size_t length, std::size_t count);

/// Centred in the cell, `scale` pixels per unit of length in both directions.
void draw_cuts(Canvas& canvas, const Rect& cell, double scale, const std::vector<CutLine>& lines);

}  // namespace sbeh::picture
