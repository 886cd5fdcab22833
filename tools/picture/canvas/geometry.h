// Points, rectangles, and what of a line lies in a rectangle.
#pragma once

#include <array>
#include <vector>

namespace sbeh::picture {

using Points = std::vector<std::array<double, 2>>;

struct Rect {
  double x = 0.0;
  double y = 0.0;
  double width = 0.0;
  double height = 0.0;

  double right() const { return x + width; }
  double top() const { return y + height; }
  double centre_x() const { return x + 0.5 * width; }
  double centre_y() const { return y + 0.5 * height; }
};

double length_of(const Points& line);

/// The pieces of a line that lie in the rectangle.
std::vector<Points> clipped(const Points& line, const Rect& inside);

}  // namespace sbeh::picture
