#include "tools/picture/chart/grid_axis.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace sbeh::picture {
namespace {

// Largest over smallest distance of neighbours: 1 for even spacing.
double unevenness(const std::vector<double>& values) {
  double smallest = std::numeric_limits<double>::infinity();
  double largest = 0.0;
  for (std::size_t i = 1; i < values.size(); ++i) {
    smallest = std::min(smallest, values[i] - values[i - 1]);
    largest = std::max(largest, values[i] - values[i - 1]);
  }
  return largest / smallest;
}

std::vector<double> logarithms(const std::vector<double>& values) {
  std::vector<double> result;
  for (const double value : values) result.push_back(std::log10(value));
  return result;
}

std::vector<double> edges_of(const std::vector<double>& centres) {
  const std::size_t n = centres.size();
  std::vector<double> edges(n + 1);
  for (std::size_t i = 1; i < n; ++i) edges[i] = 0.5 * (centres[i - 1] + centres[i]);
  edges[0] = n > 1 ? 2.0 * centres[0] - edges[1] : centres[0] - 0.5;
  edges[n] = n > 1 ? 2.0 * centres[n - 1] - edges[n - 1] : centres[0] + 0.5;
  return edges;
}

}  // namespace

GridAxis table_axis(const std::vector<double>& values, const std::string& title) {
  GridAxis grid;
  for (std::size_t i = 0; i < values.size(); ++i) {
    grid.centres.push_back(double(i));
    grid.axis.ticks.push_back(double(i));
    grid.axis.labels.push_back(short_number(values[i]));
  }
  grid.edges = edges_of(grid.centres);
  grid.axis.low = -0.5;
  grid.axis.high = double(values.size()) - 0.5;
  grid.axis.title = title;
  grid.values = values;
  return grid;
}

GridAxis distance_axis(const std::vector<double>& values, const std::string& title, double length,
                       double spacing) {
  const bool logarithmic = values.size() > 2 && values.front() > 0.0
                        && unevenness(logarithms(values)) < unevenness(values);
  GridAxis grid;
  grid.centres = logarithmic ? logarithms(values) : values;
  grid.edges = edges_of(grid.centres);
  const double low = grid.edges.front(), high = grid.edges.back();
  grid.axis = cropped(
      logarithmic ? decade_axis(low, high, title) : linear_axis(low, high, length, spacing, title),
      low, high);
  grid.values = values;
  return grid;
}

double share_of(const GridAxis& grid, double value) {
  const std::vector<double>&v = grid.values, &at = grid.centres;
  double place = at[0];
  if (v.size() > 1) {
    const auto above = std::upper_bound(v.begin() + 1, v.end() - 1, value);
    const auto k = std::size_t(above - v.begin());
    place = at[k - 1] + (value - v[k - 1]) / (v[k] - v[k - 1]) * (at[k] - at[k - 1]);
  }
  return (place - grid.axis.low) / (grid.axis.high - grid.axis.low);
}

}  // namespace sbeh::picture
