// The axes of pictures: ticks, labels, cells, and histories on logarithmic ones.
#include "tools/picture/chart/axis.h"

#include "tools/picture/chart/history.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace sbeh::picture {
namespace {

// ---- ticks --------------------------------------------------------------------------------------

// A round step is 1, 2 or 5 times a power of ten.
bool is_round(double step) {
  const double mantissa = step / std::pow(10., std::floor(std::log10(step) + 1e-9));
  for (const double digit : {1., 2., 5.})
    if (std::abs(mantissa - digit) < 1e-6) return true;
  return false;
}

double value_of(const std::string& label) {
  const std::string minus = "−";
  return label.starts_with(minus) ? -std::stod(label.substr(minus.size())) : std::stod(label);
}

TEST(LinearAxis, has_round_ticks_that_enclose_the_range) {
  for (const auto& [low, high] :
       {std::pair(0.6, 0.8), {-3.7, 12.1}, {1e-7, 3.3e-7}, {0., 1234.}, {-12.57, -11.9}}) {
    const Axis axis = linear_axis(low, high, 600, 80, "x");
    ASSERT_GT(axis.ticks.size(), 2u);
    ASSERT_EQ(axis.ticks.size(), axis.labels.size());
    const double step = axis.ticks[1] - axis.ticks[0];
    EXPECT_TRUE(is_round(step)) << step;
    EXPECT_LE(axis.low, low + 1e-9 * step);
    EXPECT_GE(axis.high, high - 1e-9 * step);
    EXPECT_LT(low - axis.low, step);
    EXPECT_LT(axis.high - high, step);
    for (std::size_t i = 0; i < axis.ticks.size(); ++i) {
      EXPECT_NEAR(axis.ticks[i], axis.low + double(i) * step, 1e-6 * step);
      EXPECT_NEAR(value_of(axis.labels[i]), axis.ticks[i], 1e-6 * step);
    }
    EXPECT_NEAR(axis.ticks.back(), axis.high, 1e-6 * step);
  }
}

TEST(LinearAxis, widens_a_range_of_no_width) {
  for (const double value : {0., 3., -2e-5}) {
    const Axis axis = linear_axis(value, value, 600, 80);
    EXPECT_LT(axis.low, value);
    EXPECT_GT(axis.high, value);
  }
}

TEST(LesserTicks, are_left_out_where_they_run_together) {
  const Axis axis = decade_axis(-6, 0, "t");  // the nearest, 9 and 10, 0.046 decades apart
  EXPECT_EQ(axis.ticks.size(), 55u);
  EXPECT_EQ(without_lesser_ticks(axis, 600, 4).ticks.size(), 55u);
  const Axis plain = without_lesser_ticks(axis, 600, 5);
  EXPECT_EQ(plain.ticks.size(), 7u);
  EXPECT_EQ(plain.labels.front(), "10⁻⁶");
  EXPECT_EQ(std::pair(plain.low, plain.high), std::pair(axis.low, axis.high));
  EXPECT_EQ(plain.title, "t");
}

TEST(CroppedAxis, keeps_the_ticks_that_lie_in_it) {
  const Axis axis = cropped(linear_axis(0, 1, 600, 120, "x"), 0.15, 0.6);
  EXPECT_EQ(axis.low, 0.15);
  EXPECT_EQ(axis.high, 0.6);
  EXPECT_EQ(axis.labels, (std::vector<std::string>{"0.2", "0.4", "0.6"}));
  EXPECT_EQ(axis.title, "x");
}

std::vector<std::string> shown(const Axis& axis) {
  std::vector<std::string> labels;
  for (const std::string& label : axis.labels)
    if (!label.empty()) labels.push_back(label);
  return labels;
}

TEST(DecadeAxis, labels_decades_and_on_shorter_axes_the_digits_between) {
  EXPECT_EQ(shown(decade_axis(-5, 1, "t")),
            (std::vector<std::string>{"10⁻⁵", "10⁻⁴", "0.001", "0.01", "0.1", "1", "10"}));
  EXPECT_EQ(shown(decade_axis(0, 2, "t")),
            (std::vector<std::string>{"1", "2", "5", "10", "20", "50", "100"}));
  EXPECT_EQ(shown(decade_axis(std::log10(1.5), std::log10(4.5), "t")),
            (std::vector<std::string>{"2", "3", "4"}));
  const Axis axis = decade_axis(-2, 3, "t");
  EXPECT_EQ(axis.ticks.size(), 5u * 9u + 1u);
  EXPECT_EQ(axis.low, -2);
  EXPECT_EQ(axis.high, 3);
}

// ---- cells --------------------------------------------------------------------------------------

TEST(GridAxis, as_a_table_has_equal_cells_with_their_values) {
  const std::vector<double> values{0.005, 0.01, 0.07};
  const GridAxis grid = table_axis(values, "L");
  EXPECT_EQ(grid.edges, (std::vector<double>{-0.5, 0.5, 1.5, 2.5}));
  EXPECT_EQ(grid.axis.labels, (std::vector<std::string>{"0.005", "0.01", "0.07"}));
  for (std::size_t i = 0; i < values.size(); ++i)
    EXPECT_NEAR(share_of(grid, values[i]), (double(i) + 0.5) / 3, 1e-15);
}

TEST(GridAxis, has_its_edges_midway_between_values_that_are_evenly_spaced_in_one_scale) {
  const GridAxis even = distance_axis({0.6, 0.7, 0.8}, "V", 500, 80);
  const std::vector<double> edges{0.6, 0.65, 0.75, 0.8};
  for (std::size_t i = 0; i < edges.size(); ++i) EXPECT_NEAR(even.edges[i], edges[i], 1e-15);
  const GridAxis logarithmic = distance_axis({0.01, 0.1, 1}, "L", 500, 80);
  const std::vector<double> exponents{-2, -1.5, -0.5, 0};
  for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(logarithmic.edges[i], exponents[i], 1e-14);
  const std::vector<std::string> labels = shown(logarithmic.axis);
  for (const char* decade : {"0.01", "0.1", "1"})
    EXPECT_TRUE(std::ranges::find(labels, decade) != labels.end()) << decade;
  for (const GridAxis* grid : {&even, &logarithmic})
    for (std::size_t i = 0; i < 3; ++i)
      EXPECT_NEAR(share_of(*grid, grid->values[i]), double(i) / 2, 1e-14);
  EXPECT_NEAR(share_of(even, 0.9), 1.5, 1e-14);  // goes on beyond the last value
}

// ---- labels -------------------------------------------------------------------------------------

// Whether two labels that follow each other touch.
bool runs_together(const Axis& axis, double extent, double length, double gap) {
  double end = -1e300;
  for (std::size_t i = 0; i < axis.ticks.size(); ++i) {
    if (axis.labels[i].empty()) continue;
    const double middle = axis.share(axis.ticks[i]) * length;
    if (middle - extent / 2 < end + gap - 1e-9) return true;
    end = middle + extent / 2;
  }
  return false;
}

TEST(Labels, do_not_run_together_and_as_many_as_can_stay) {
  std::vector<double> many;
  many.reserve(27);
  for (int i = 0; i < 27; ++i) many.push_back(0.35 + 0.0217 * i);
  for (const Axis& axis :
       {table_axis(many, "V").axis, distance_axis(many, "V", 300, 10).axis, decade_axis(-6, 3, "t"),
        decade_axis(0, 2, "t"), linear_axis(-1e-7, 1e-7, 300, 20)})
    for (const double extent : {5., 20., 44., 90., 250.}) {
      const double length = 300, gap = 6;
      const Axis few =
          without_crowd(axis, std::vector<double>(axis.ticks.size(), extent), length, gap);
      EXPECT_FALSE(runs_together(few, extent, length, gap)) << extent;
      EXPECT_EQ(few.ticks, axis.ticks);
      EXPECT_FALSE(shown(few).empty());
      EXPECT_EQ(shown(few).front(), shown(axis).front());
      if (!runs_together(axis, extent, length, gap)) {
        EXPECT_EQ(few.labels, axis.labels);
      }
    }
}

// ---- histories ----------------------------------------------------------------------------------

TEST(History, leaves_out_what_is_too_early_to_be_seen_and_no_energy) {
  EXPECT_EQ(over_time({0, 1e-9, 0.1, 1, 10}, {5, 5, -20, 1, 10}, 0),
            (Points{{-1, -20}, {0, 1}, {1, 10}}));
  EXPECT_EQ(over_time({1, 10}, {-4, -8}, 5), (Points{{0, 1}, {1, -3}}));
  EXPECT_TRUE(over_time({}, {}, 0).empty());
}

// Below −4π with a deeper well, negative with a spontaneous curvature, zero.
TEST(History, is_linear_as_soon_as_one_energy_has_no_logarithm) {
  EXPECT_EQ(scale_for({{{0, 1}, {1, 1e-12}}, {{0, 3}}}), EnergyScale::logarithmic);
  for (const double energy : {0., -1e-12, -20., std::numeric_limits<double>::quiet_NaN()})
    EXPECT_EQ(scale_for({{{0, 1}, {1, 2}}, {{0, 3}, {1, energy}}}), EnergyScale::linear);
  const Points curve{{0, -13}, {1, 2}};
  EXPECT_EQ(on_scale(curve, EnergyScale::linear, 15), curve);
  const HistoryAxes axes = history_axes({curve}, EnergyScale::linear, "U", 400, Options{});
  EXPECT_LT(axes.energy.low, -13);
  EXPECT_GT(axes.energy.high, 2);
  EXPECT_FALSE(shown(axes.energy).empty());
}

TEST(History, thins_points_too_close_to_tell_apart_and_keeps_the_last) {
  std::vector<double> time, value;
  for (int i = 0; i <= 100000; ++i) {
    time.push_back(1 + 9e-5 * i);
    value.push_back(2 + std::sin(time.back()));
  }
  for (const EnergyScale scale : {EnergyScale::logarithmic, EnergyScale::linear}) {
    const Points points = on_scale(over_time(time, value, 0), scale, 2);
    EXPECT_LT(points.size(), 2000u);
    EXPECT_EQ(points.back()[0], std::log10(time.back()));
    for (std::size_t i = 1; i < points.size(); ++i)  // no gap wider than the resolution and a step
      EXPECT_LT(points[i][0] - points[i - 1][0], 0.0041);
  }
}

TEST(History, ends_at_the_floor_of_a_logarithmic_scale) {
  const Points curve{{0, 1e-9}, {1, 1e-3}, {2, 1}};
  EXPECT_EQ(on_scale(curve, EnergyScale::logarithmic, 1, -5), (Points{{1, -3}, {2, 0}}));
  EXPECT_EQ(on_scale(curve, EnergyScale::logarithmic, 1).size(), 3u);
}

TEST(History, has_one_pair_of_axes_for_all_curves) {
  const HistoryAxes axes = history_axes({{{-3, 1}, {0, 2}}, {{-4, 0}, {1, 1}}},
                                        EnergyScale::logarithmic, "U", 400, Options{});
  EXPECT_EQ(axes.time.low, -4);
  EXPECT_EQ(axes.time.high, 1);
  EXPECT_NEAR(axes.energy.low, -0.08, 1e-15);  // 4 % of room
  EXPECT_NEAR(axes.energy.high, 2.08, 1e-15);
  EXPECT_EQ(axes.energy.title, "U");
}

}  // namespace
}  // namespace sbeh::picture
