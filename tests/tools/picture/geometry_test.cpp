// Lines in pictures: what of them lies in a rectangle, and contours.
#include "tools/picture/canvas/geometry.h"

#include "tools/picture/scan/chains.h"
#include "tools/picture/scan/contours.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numeric>

namespace sbeh::picture {
namespace {

constexpr Rect unit{0, 0, 1, 1};

// ---- clipping -----------------------------------------------------------------------------------

// Of numbers with few binary digits, so that nothing is rounded.
TEST(Clipping, leaves_a_line_inside_as_it_is_and_nothing_of_one_outside) {
  const Points inside{{0.125, 0.25}, {0.5, 0.875}, {0.75, 0.375}};
  EXPECT_EQ(clipped(inside, unit), std::vector<Points>{inside});
  EXPECT_TRUE(clipped({{-1, 2}, {2, 2}}, unit).empty());
  EXPECT_TRUE(clipped({{-1, 0.5}, {0.5, 2.5}}, unit).empty());  // past a corner
  EXPECT_TRUE(clipped({{2, -1}, {2, 3}}, unit).empty());        // parallel to a side
}

TEST(Clipping, cuts_at_the_sides) {
  EXPECT_EQ(clipped({{-1, 0.5}, {3, 0.5}}, unit), (std::vector<Points>{{{0, 0.5}, {1, 0.5}}}));
  EXPECT_EQ(clipped({{-1, -1}, {3, 3}}, unit), (std::vector<Points>{{{0, 0}, {1, 1}}}));
  EXPECT_EQ(clipped({{0.5, 0.5}, {0.5, 2.5}}, unit), (std::vector<Points>{{{0.5, 0.5}, {0.5, 1}}}));
}

TEST(Clipping, makes_two_pieces_of_a_line_that_comes_back) {
  const auto pieces = clipped({{0.5, 0.5}, {1.5, 0.5}, {1.5, 0.25}, {0.5, 0.25}}, unit);
  EXPECT_EQ(pieces, (std::vector<Points>{{{0.5, 0.5}, {1, 0.5}}, {{1, 0.25}, {0.5, 0.25}}}));
}

// What is cut off by one cell of a tiling is in the others.
TEST(Clipping, by_the_cells_of_a_tiling_keeps_the_length) {
  Points spiral;
  for (double t = 0; t < 40; t += 0.37)
    spiral.push_back({2 + 0.045 * t * std::cos(t), 1.5 + 0.036 * t * std::sin(t)});
  double length = 0;
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 3; ++j)
      for (const Points& piece : clipped(spiral, {double(i), double(j), 1, 1}))
        length += length_of(piece);
  EXPECT_NEAR(length, length_of(spiral), 1e-12 * length_of(spiral));
}

// ---- dashes -------------------------------------------------------------------------------------

TEST(Dashes, of_a_line_are_its_share_and_lie_on_it) {
  Points circle;
  for (int i = 0; i <= 720; ++i)
    circle.push_back({10 * std::cos(i * 0.00873), 10 * std::sin(i * 0.00873)});
  const double length = length_of(circle);
  for (const auto& lengths :
       {std::vector<double>{1, 1}, {3, 1}, {0.01, 0.02}, {2, 0.5, 0.5, 0.5}, {7, 100}}) {
    double period = 0, drawn = 0, found = 0;
    for (std::size_t k = 0; k < lengths.size(); ++k) {
      period += lengths[k];
      if (k % 2 == 0) drawn += lengths[k];
    }
    for (const Points& piece : dashes(circle, lengths)) {
      found += length_of(piece);
      EXPECT_LE(length_of(piece), lengths[0] + 1e-9);
      for (const auto& [x, y] : piece) EXPECT_NEAR(std::hypot(x, y), 10, 1e-3);
    }
    EXPECT_NEAR(found, drawn / period * length, period);
  }
  EXPECT_EQ(dashes(circle, {}), std::vector<Points>{circle});
}

// ---- contours -----------------------------------------------------------------------------------

struct Grid {
  std::vector<double> x, y;
  std::vector<std::vector<double>> values;
};
template <class Function>
Grid sampled(int n, double half, Function f) {
  Grid grid;
  for (int i = 0; i <= n; ++i) grid.x.push_back(half * (2. * i / n - 1));
  grid.y = grid.x;
  for (const double x : grid.x) {
    auto& column = grid.values.emplace_back();
    for (const double y : grid.y) column.push_back(f(x, y));
  }
  return grid;
}
std::vector<Points> contours_of(const Grid& grid, double level) {
  return contour_lines(grid.x, grid.y, grid.values, level);
}

TEST(Contours, of_a_linear_field_are_exact) {
  const auto lines = contours_of(sampled(7, 1, [](double x, double y) { return x + 2 * y; }), 0.25);
  ASSERT_EQ(lines.size(), 1u);
  for (const auto& [x, y] : lines[0]) EXPECT_NEAR(x + 2 * y, 0.25, 1e-6);  // single precision
  EXPECT_NEAR(length_of(lines[0]), std::sqrt(5), 1e-6);                    // from x = −1 to x = 1
}

// Linear between the points of the grid, at the distance h: off by h²/8 times the second derivative, which is
// at most 1/r.
TEST(Contours, of_a_circle_close_and_are_as_exact_as_linear_interpolation) {
  for (const int n : {10, 20, 40, 80}) {
    const auto lines = contours_of(sampled(n, 1.1, std::hypot<double, double>), 0.7);
    ASSERT_EQ(lines.size(), 1u);
    EXPECT_EQ(lines[0].front(), lines[0].back());
    const double h = 2.2 / n, single_precision = 1e-6;
    for (const auto& [x, y] : lines[0])
      EXPECT_NEAR(std::hypot(x, y), 0.7, h * h / 8 / (0.7 - h) + single_precision);
  }
}

TEST(Contours, do_not_enter_cells_without_a_value) {
  Grid grid = sampled(10, 1, [](double x, double) { return x; });
  for (std::size_t i = 0; i < grid.x.size(); ++i)
    grid.values[i][5] = std::numeric_limits<double>::quiet_NaN();  // along y = 0
  const auto lines = contours_of(grid, 0.1);
  ASSERT_EQ(lines.size(), 2u);
  for (const Points& line : lines)
    for (const auto& [x, y] : line) EXPECT_GE(std::abs(y), 0.2 - 1e-6);
  EXPECT_TRUE(contours_of(grid, 3).empty());
}

// ---- of cells -----------------------------------------------------------------------------------

constexpr double none = std::numeric_limits<double>::quiet_NaN();

GridAxis axis_of(int count) {
  std::vector<double> values(std::size_t(count), 0.0);
  std::iota(values.begin(), values.end(), 0.0);
  return distance_axis(values, "", 100, 10);
}

// Whether a point is on the edge of the map or of a cell that has no value.
bool is_at_edge(double x, double y, const std::vector<std::vector<double>>& values) {
  const double last_x = double(values.size()) - 1, last_y = double(values[0].size()) - 1;
  constexpr double off = 1e-5;
  for (const double dx : {-off, off})
    for (const double dy : {-off, off}) {
      if (x + dx < 0 || x + dx > last_x || y + dy < 0 || y + dy > last_y) return true;
      if (!std::isfinite(
              values[std::size_t(std::lround(x + dx))][std::size_t(std::lround(y + dy))]))
        return true;
    }
  return false;
}

// Straight up to the map's edges, around a corner without values, beside a stair, through a hole.
TEST(ContoursOfCells, end_at_edges_and_nowhere_else) {
  const GridAxis x = axis_of(9), y = axis_of(7);
  std::vector<std::vector<double>> slope(9, std::vector<double>(7));
  for (std::size_t i = 0; i < 9; ++i)
    for (std::size_t j = 0; j < 7; ++j) slope[i][j] = 2 * double(i) + double(j);
  auto corner = slope, stair = slope, hole = slope;
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 4; j < 7; ++j) corner[i][j] = none;
  for (std::size_t i = 0; i < 9; ++i)
    for (std::size_t j = 0; j < 7; ++j)
      if (i + j < 5) stair[i][j] = none;
  hole[4][3] = none;
  for (const auto& values : {slope, corner, stair, hole})
    for (const double level : {3.3, 7.1, 10.2, 15.5}) {
      for (const Points& line : contours_of_cells(x, y, values, level)) {
        for (const auto& [px, py] : {line.front(), line.back()})
          EXPECT_TRUE(is_at_edge(px, py, values)) << level << ": " << px << ", " << py;
        for (const auto& [px, py] : line) EXPECT_NEAR(2 * px + py, level, 1e-5);
      }
    }
}

TEST(ContoursOfCells, of_a_single_cell_with_a_value_do_not_leave_it) {
  std::vector<std::vector<double>> values(5, std::vector<double>(5, none));
  values[2][2] = 1;
  for (const double level : {0.5, 1.5})
    EXPECT_TRUE(contours_of_cells(axis_of(5), axis_of(5), values, level).empty());
}

// Where x = √(a² + y²) and its mirror image cross the lines of a grid, in no order.
Points crossings_of_hyperbola(double a, double middle) {
  Points points;
  for (const int k : {3, 0, 7, 5, 1, 8, 2, 6, 4})
    for (const double sign : {1.0, -1.0}) {
      const double y = k - 4.0;
      points.push_back({middle + sign * std::sqrt(a * a + y * y), double(k)});
      if (std::abs(y) > a) {
        const double x = middle + sign * std::abs(y), up = std::sqrt(y * y - a * a);
        points.push_back({x, 4.0 + (y > 0 ? up : -up)});
      }
    }
  return points;
}

TEST(Chains, join_the_crossings_of_each_curve_in_their_order) {
  const Points points = crossings_of_hyperbola(2.3, 20.0);
  const auto found = chains(points);
  ASSERT_EQ(found.size(), 2u);
  for (const auto& chain : found)
    for (std::size_t k = 1; k < chain.size(); ++k) {
      const auto &a = points[chain[k - 1]], &b = points[chain[k]];
      EXPECT_GT((a[0] - 20.0) * (b[0] - 20.0), 0.0);
      EXPECT_LT(std::hypot(a[0] - b[0], a[1] - b[1]), std::sqrt(2.0));
      EXPECT_GT((b[1] - a[1]) * (points[chain[1]][1] - points[chain[0]][1]), 0.0);
    }
}

TEST(Chains, leave_out_cells_in_which_it_cannot_be_said_what_belongs_together) {
  EXPECT_EQ(chains({{0.0, 0.4}, {0.4, 0.0}, {0.6, 1.0}, {1.0, 0.6}}).size(), 4u);  // two ways
  EXPECT_EQ(chains({{0.3, 0.0}, {0.7, 0.0}}).size(), 2u);                          // one side twice
  EXPECT_EQ(chains({{0.3, 0.0}, {0.7, 2.0}}).size(), 2u);                          // no common cell
  EXPECT_EQ(chains({{0.3, 0.0}, {0.7, 1.0}, {0.9, 2.0}}).size(), 1u);
  EXPECT_EQ(chains({{0.5, 0.0}, {1.0, 0.5}, {0.5, 1.0}, {0.0, 0.5}, {3.5, 0.0}}).size(), 5u);
  EXPECT_TRUE(chains({}).empty());
}

TEST(Chains, close_around_a_point_of_the_grid) {
  const auto found = chains({{1.2, 1.0}, {1.0, 0.7}, {1.0, 1.4}, {0.9, 1.0}});
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].size(), 4u);
}

}  // namespace
}  // namespace sbeh::picture
