#include "tools/picture/chart/panels.h"

#include <gtest/gtest.h>

namespace sbeh::picture {
namespace {

const PanelNeeds three{.count = 3,
                       .most_columns = 3,
                       .usual_width = 500.0,
                       .least_width = 200.0,
                       .side = 50.0,
                       .left = 10.0,
                       .right = 40.0,
                       .below = 30.0,
                       .above = 20.0,
                       .bottom = 15.0,
                       .top = 25.0};

PanelGrid of_width(double mm) {
  Options options;
  options.width_mm = mm;
  return arranged(three, options);
}

TEST(Panels, stand_side_by_side_as_many_as_have_room) {
  EXPECT_EQ(arranged(three, {}).columns, 3u);
  EXPECT_EQ(arranged(three, {}).width, 1500.0);
  std::size_t columns = 3;
  for (int mm = 86; mm > 5; --mm) {
    const PanelGrid grid = of_width(mm);
    EXPECT_LE(grid.columns, columns);
    columns = grid.columns;
    EXPECT_TRUE(grid.inner_width >= three.least_width || columns == 1) << mm;
    // One more would have no room.
    const double more = (grid.width - three.side) / double(columns + 1) - three.left - three.right;
    EXPECT_TRUE(columns == 3 || more < three.least_width) << mm;
  }
  EXPECT_EQ(columns, 1u);
}

TEST(Panels, fill_the_picture_without_overlaps) {
  for (const double mm : {86.0, 50.0, 25.0}) {
    const PanelGrid grid = of_width(mm);
    EXPECT_GE(grid.columns * grid.rows, 3u);
    for (std::size_t i = 0; i < 3; ++i) {
      const Rect at = grid.inside(i);
      EXPECT_GE(at.x, three.side + three.left);
      EXPECT_LE(at.right(), grid.width - three.right + 1e-9);
      EXPECT_GE(at.y, three.bottom + three.below - 1e-9);
      EXPECT_LE(at.top(), grid.height - three.top - three.above + 1e-9);
      EXPECT_EQ(grid.begins_row(i), at.x == three.side + three.left);
      if (i == 0) continue;
      const Rect before = grid.inside(i - 1);
      if (grid.begins_row(i))
        EXPECT_NEAR(at.top() + three.above + three.below, before.y, 1e-9);
      else
        EXPECT_NEAR(at.x - three.left - three.right, before.right(), 1e-9);
    }
  }
}

}  // namespace
}  // namespace sbeh::picture
