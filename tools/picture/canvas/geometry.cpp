#include "tools/picture/canvas/geometry.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace sbeh::picture {
namespace {

// The part of a segment inside, by Liang and Barsky; empty when there is none.
using Point = Points::value_type;
std::optional<std::pair<Point, Point>> clipped(const Point& from, const Point& to,
                                               const Rect& inside) {
  double begin = 0, end = 1;
  const auto limit = [&](double start, double change, double low, double high) {
    if (change == 0) return start >= low && start <= high;
    double enter = (low - start) / change, leave = (high - start) / change;
    if (enter > leave) std::swap(enter, leave);
    begin = std::max(begin, enter);
    end = std::min(end, leave);
    return begin < end;
  };
  const double dx = to[0] - from[0], dy = to[1] - from[1];
  if (!limit(from[0], dx, inside.x, inside.right()) || !limit(from[1], dy, inside.y, inside.top()))
    return {};
  return std::pair(Point{from[0] + begin * dx, from[1] + begin * dy},
                   Point{from[0] + end * dx, from[1] + end * dy});
}

}  // namespace

double length_of(const Points& line) {
  double length = 0.0;
  for (std::size_t i = 1; i < line.size(); ++i)
    length += std::hypot(line[i][0] - line[i - 1][0], line[i][1] - line[i - 1][1]);
  return length;
}

std::vector<Points> clipped(const Points& line, const Rect& inside) {
  std::vector<Points> pieces;
  for (std::size_t i = 1; i < line.size(); ++i) {
    const auto piece = clipped(line[i - 1], line[i], inside);
    if (!piece) continue;
    if (pieces.empty() || pieces.back().back() != piece->first) pieces.push_back({piece->first});
    pieces.back().push_back(piece->second);
  }
  return pieces;
}

}  // namespace sbeh::picture
