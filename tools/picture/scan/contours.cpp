#include "tools/picture/scan/contours.h"

#include <cmath>
#include <limits>
#include <utility>

namespace sbeh::picture {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

using Values = std::vector<double>;

// Edges and centres in turn; an edge in the middle of its cell is left out.
Values places_on(const GridAxis& axis) {
  Values places;
  for (std::size_t i = 0; i < axis.centres.size(); ++i) {
    if (axis.edges[i] != axis.centres[i]) places.push_back(axis.edges[i]);
    places.push_back(axis.centres[i]);
  }
  if (axis.edges.back() != axis.centres.back()) places.push_back(axis.edges.back());
  return places;
}

// At `place`, on the line through the values of cells a and b, or as a's where b has none.
double along(const GridAxis& axis, const Values& f, std::size_t a, std::size_t b, double place) {
  if (!std::isfinite(f[a])) return none;
  if (a == b || !std::isfinite(f[b])) return f[a];
  return f[a] + (f[b] - f[a]) * (place - axis.centres[a]) / (axis.centres[b] - axis.centres[a]);
}

// The values in the cells of one row at its places.
Values refined(const GridAxis& axis, const Values& f) {
  const std::size_t n = f.size();
  const auto at_edge = [&](std::size_t i) {  // between cells i − 1 and i
    const double place = axis.edges[i];
    if (i > 0 && i < n && std::isfinite(f[i - 1]) && std::isfinite(f[i]))
      return along(axis, f, i - 1, i, place);
    if (i > 0 && std::isfinite(f[i - 1]))
      return along(axis, f, i - 1, i > 1 ? i - 2 : i - 1, place);
    return i < n ? along(axis, f, i, i + 1 < n ? i + 1 : i, place) : none;
  };
  Values all;
  for (std::size_t i = 0; i < n; ++i) {
    if (axis.edges[i] != axis.centres[i]) all.push_back(at_edge(i));
    all.push_back(f[i]);
  }
  if (axis.edges[n] != axis.centres[n - 1]) all.push_back(at_edge(n));
  return all;
}

std::vector<Values> transposed(const std::vector<Values>& table) {
  std::vector<Values> turned(table.front().size());
  for (const Values& row : table)
    for (std::size_t j = 0; j < row.size(); ++j) turned[j].push_back(row[j]);
  return turned;
}

}  // namespace

std::vector<Points> contours_of_cells(const GridAxis& x, const GridAxis& y,
                                      const std::vector<Values>& values, double level) {
  std::vector<Values> along_y, along_x;
  for (const Values& column : values) along_y.push_back(refined(y, column));
  for (const Values& row : transposed(along_y)) along_x.push_back(refined(x, row));
  return contour_lines(places_on(x), places_on(y), transposed(along_x), level);
}

}  // namespace sbeh::picture
