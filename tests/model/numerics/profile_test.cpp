#include "model/numerics/profile.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace sbeh::model {
namespace {

Eigen::Matrix2Xd points(std::initializer_list<Eigen::Vector2d> list) {
  Eigen::Matrix2Xd p(2, Eigen::Index(list.size()));
  Eigen::Index i = 0;
  for (const auto& x : list) p.col(i++) = x;
  return p;
}

TEST(Polygon, of_a_convex_curve_does_not_meet_itself) {
  Eigen::Matrix2Xd p(2, 20);
  for (int i = 0; i < 20; ++i) {
    const double t = std::numbers::pi * i / 19;
    p.col(i) << std::sin(t), std::cos(t);
  }
  EXPECT_FALSE(meets_itself(p));
}

TEST(Polygon, meets_itself_where_two_sides_cross_touch_or_lie_on_each_other) {
  EXPECT_TRUE(meets_itself(points({{0, 0}, {1, 1}, {1, 0}, {0, 1}})));
  EXPECT_TRUE(meets_itself(points({{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 0}})));
  EXPECT_TRUE(meets_itself(points({{0, 0}, {2, 0}, {2, 1}, {3, 0}, {1, 0}})));
  EXPECT_FALSE(meets_itself(points({{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 0.01}})));
}

TEST(Polygon, meets_itself_wherever_along_a_long_one_its_sides_cross) {
  // A zigzag to the right, then above it back to half of side `crossed`, and down: through it or not.
  constexpr int sides = 100;
  for (int crossed = 0; crossed < sides - 1; ++crossed)
    for (const bool through : {false, true}) {
      Eigen::Matrix2Xd p(2, sides + 4);
      for (int i = 0; i <= sides; ++i) p.col(i) << i, i % 2;
      p.rightCols<3>() << sides + 1, crossed + 0.5, crossed + 0.5,  //
          3, 3, through ? 0.2 : 1.5;
      EXPECT_EQ(meets_itself(p), through) << crossed;
    }
}

TEST(Polygon, does_not_meet_itself_where_neighbours_do) {
  EXPECT_FALSE(meets_itself(points({{0, 0}, {1, 0}, {0.5, 0}})));
}

}  // namespace
}  // namespace sbeh::model
