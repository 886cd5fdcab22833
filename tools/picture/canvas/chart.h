// A chart of VTK at a given place: axes with the ticks we say, curves in data coordinates.
#pragma once

#include "tools/picture/canvas/canvas.h"

#include <string>
#include <vector>

class vtkChartXY;

namespace sbeh::picture {

/// The range is shown exactly as it is; an axis without title and ticks is not drawn.
struct Axis {
  double low = 0.0;
  double high = 1.0;
  std::string title;
  std::vector<double> ticks;
  std::vector<std::string> labels;  ///< one per tick, may be empty texts
};

/// Round numbers for ticks about `spacing` pixels apart on an axis of `length` pixels; the range is
/// widened to the next ticks.
Axis linear_axis(double low, double high, double length, double spacing, std::string title = {});

/// The same axis from `low` to `high`, with the ticks that lie there.
Axis cropped(const Axis& axis, double low, double high);

/// For data given as log₁₀: a labelled tick per decade, on shorter axes also at 2 and 5, or at all
/// digits; the ticks between are unlabelled.
Axis decade_axis(double log_low, double log_high, std::string title);

enum class Marker { full, hollow, cross };

/// The room that labels and title take below the lower axis.
double below_axis(double text_size);

class Chart {
 public:
  /// `inside` is the rectangle between the axes; labels and titles go beyond it.
  Chart(Canvas& canvas, const Rect& inside, double text_size, const Axis& x, const Axis& y);

  void curve(const Points& points, const LineStyle& style);
  /// A curve with one colour per point.
  void coloured_curve(const Points& points, const std::vector<Colour>& colours, double width);
  void markers(const Points& points, Marker marker, Colour colour, double size);

 private:
  vtkChartXY* chart_;  // owned by the canvas
};

}  // namespace sbeh::picture
