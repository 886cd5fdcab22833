// Points, rectangles, ranges; what of a line lies in a rectangle; contour lines.
#pragma once

#include <algorithm>
#include <array>
#include <limits>
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
  Points outline() const { return {{x, y}, {right(), y}, {right(), top()}, {x, top()}, {x, y}}; }
};

/// Of the values included; empty at first.
struct Range {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();

  bool empty() const { return !(low <= high); }
  double width() const { return high - low; }
  void include(double value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
  void include(const Range& other) {
    low = std::min(low, other.low);
    high = std::max(high, other.high);
  }
  bool operator==(const Range&) const = default;
};

double length_of(const Points& line);

/// The pieces of a line that lie in the rectangle.
std::vector<Points> clipped(const Points& line, const Rect& inside);

/// The drawn pieces of a line whose lengths are drawn and left out in turn: drawn for lengths[0], not for lengths[1] …
/// All of it without lengths.
std::vector<Points> dashes(const Points& line, const std::vector<double>& lengths);

/// values[i][j] at (x[i], y[j]), NaN where there is none; only cells with four values have contours.
std::vector<Points> contour_lines(const std::vector<double>& x, const std::vector<double>& y,
                                  const std::vector<std::vector<double>>& values, double level);

}  // namespace sbeh::picture
