// How long an evolution has still to go.
#include "studies/evolution/flow_progress.h"

#include <gtest/gtest.h>

#include <cmath>

namespace sbeh::studies {
namespace {

// Steps of a second each that grow by a factor from `step` on up to `largest`.
struct Steps {
  double step, factor, largest;
  double time = 0, seconds = 0;
  void go(TimeLeft& left, int count) {
    for (int i = 0; i < count; ++i) {
      time += step;
      ++seconds;
      left.see(time, seconds);
      step = std::min(largest, factor * step);
    }
  }
};

TEST(TimeLeft, is_exact_where_all_steps_are_the_same) {
  TimeLeft left;
  Steps steps{.step = 0.01, .factor = 1, .largest = 0.01};
  steps.go(left, 100);
  ASSERT_TRUE(left.until(3));
  EXPECT_NEAR(*left.until(3), 200, 1e-9);
  EXPECT_EQ(left.until(0.5), 0);
}

TEST(TimeLeft, is_not_known_while_steps_grow_on_new_triangles_and_right_soon_after) {
  TimeLeft left;
  Steps steps{.step = 0.01, .factor = 1, .largest = 0.01};
  steps.go(left, 100);
  steps.step = 1e-6;  // the first on new triangles
  steps.factor = 1.5;
  int last_known = 0;
  for (int i = 1; i <= 100; ++i) {
    steps.go(left, 1);
    const double rest = 3 - steps.time, exact = rest / 0.01;  // but for what the growth still takes
    if (const auto told = left.until(3)) {
      last_known = i;
      EXPECT_LT(*told, 2.5 * exact) << i;
    }
  }
  EXPECT_EQ(last_known, 100);
  EXPECT_NEAR(*left.until(3), (3 - steps.time) / 0.01, 1e-6);
}

TEST(TimeLeft, is_not_known_of_the_first_steps) {
  TimeLeft left;
  Steps steps{.step = 0.01, .factor = 1, .largest = 0.01};
  steps.go(left, 10);
  EXPECT_FALSE(left.until(3));
}

}  // namespace
}  // namespace sbeh::studies
