// Zeros against closed values.
#include "model/numerics/root.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

namespace sbeh::model {
namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();

TEST(Root, lies_in_a_bracket_of_the_width_asked_for) {
  const auto f = [](double x) { return x * x * x - 2; };
  for (const int bits : {20, 40, 50}) {
    const Bracket b = root_between(f, 0, 8, bits);
    EXPECT_LE(b.low, std::cbrt(2)) << bits;
    EXPECT_GE(b.high, std::cbrt(2)) << bits;
    EXPECT_LE(b.high - b.low, std::ldexp(b.high, 1 - bits)) << bits;
  }
}

TEST(Root, may_be_an_end_of_the_interval) {
  EXPECT_EQ(root_between([](double x) { return x; }, 0, 1).middle(), 0);
  EXPECT_EQ(root_between([](double x) { return x - 1; }, 0, 1).middle(), 1);
}

TEST(Root, needs_a_change_of_sign) {
  EXPECT_THROW(root_between([](double x) { return x * x + 1; }, -1, 1), std::domain_error);
}

TEST(Root, by_secants_is_where_the_function_was_last_evaluated) {
  double last = 0;
  const auto f = [&](double x) { return last = x, std::cos(x); };
  const double root = root_near(1.4, 1.5, f, 1e-12);
  EXPECT_EQ(root, last);
  EXPECT_NEAR(root, std::numbers::pi / 2, 2 * epsilon);  // the error is far below the last change
}

}  // namespace
}  // namespace sbeh::model
