#include "tools/picture/surface/frames.h"

#include <gtest/gtest.h>

namespace sbeh::picture {
namespace {

TEST(ColoursOfSurfaces, show_all_of_an_order_and_a_curvature_without_its_extremes) {
  std::vector<double> values;
  values.reserve(1000);
  for (int i = 0; i < 1000; ++i) values.push_back(0.01 * i);
  values.front() = -500.0;
  values.back() = 1000.0;
  EXPECT_EQ(shown_range(values, Field::order), (Range{-500.0, 1000.0}));
  const Range curvature = shown_range(values, Field::curvature);
  EXPECT_NEAR(curvature.low, 0.1, 0.02);
  EXPECT_NEAR(curvature.high, 9.9, 0.02);
  EXPECT_NE(shown_title(Field::curvature, {}), title_of(Field::curvature));
  EXPECT_EQ(shown_title(Field::order, {}), title_of(Field::order));
  Options options;
  options.scale = Range{-1.0, 1.0};
  EXPECT_EQ(shown_title(Field::curvature, options), title_of(Field::curvature));
}

TEST(ColoursOfSurfaces, do_not_show_noise) {
  const Range sphere = shown_range({-2.0, -2.0 + 1e-12, -2.0 - 1e-12}, Field::curvature);
  EXPECT_NEAR(sphere.width(), 0.04, 1e-10);
  EXPECT_EQ(shown_range({3.0}, Field::order), (Range{3.0, 3.0}));
}

}  // namespace
}  // namespace sbeh::picture
