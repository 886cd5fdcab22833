// A chart of VTK at a given place: axes with the ticks we say, curves in data coordinates.
#pragma once

#include "tools/picture/canvas/canvas.h"
#include "tools/picture/chart/axis.h"

#include <vector>

class vtkChartXY;

namespace sbeh::picture {

enum class Marker { full, hollow, dotted, cross, plus, diamond, circle };

/// The room that labels and title take below the lower axis.
double below_axis(double text_size);

class Chart {
 public:
  /// `inside` is the rectangle between the axes; labels and titles go beyond it.
  Chart(Canvas& canvas, const Rect& inside, double text_size, const Axis& x, const Axis& y);

  void curve(const Points& points, const LineStyle& style);
  /// A curve with one colour per point, in a thin dark border: the lightest is not seen on white.
  void coloured_curve(const Points& points, const std::vector<Colour>& colours, double width);
  void markers(const Points& points, Marker marker, Colour colour, double size);

 private:
  Points to_pixels(const Points& points) const;
  Points to_data(const Points& pixels) const;

  vtkChartXY* chart_;  // owned by the canvas
  double unit_ = 1.0;  // of widths of lines
  Rect inside_;
  Range x_, y_;
};

}  // namespace sbeh::picture
