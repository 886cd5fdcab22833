// Continuation around the circle x² + μ² = 1, which folds at μ = ±1, and along μ = x³ − εx, which folds twice.
#include "model/numerics/continuation.h"

#include <Eigen/LU>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace sbeh::model {
namespace {

struct OnCircle {
  Eigen::Vector2d z;  // x, μ
};
struct CirclePoint : OnCircle {
  Eigen::Vector2d tangent;
  double parameter() const { return z[1]; }
  double slope() const { return tangent[1]; }
};
struct Circle {
  using Solution = OnCircle;
  using Point = CirclePoint;
  static constexpr ContinuationLimits limits{
      .most_iterations = 8, .tolerance = 1e-7, .far = 0.5, .fold = 1e-10};
};

std::optional<OnCircle> predicted(const Circle&, const CirclePoint& from, double ds) {
  return OnCircle{from.z + ds * from.tangent};
}

std::optional<double> newton_step(const Circle&, OnCircle& at, const CirclePoint& from, double ds) {
  Eigen::Matrix2d matrix;
  matrix << 2 * at.z.transpose(), from.tangent.transpose();
  const Eigen::Vector2d miss(at.z.squaredNorm() - 1, from.tangent.dot(at.z - from.z) - ds);
  const Eigen::Vector2d step = -matrix.partialPivLu().solve(miss);
  at.z += step;
  return step.norm();
}

std::optional<CirclePoint> with_tangent(const Circle&, const OnCircle& at,
                                        const Eigen::Vector2d* forward) {
  const Eigen::Vector2d t(-at.z[1], at.z[0]);
  return CirclePoint{at, t.dot(*forward) < 0 ? -t : t};
}

bool continues(const Circle&, const CirclePoint& a, const CirclePoint& b, double) {
  return a.tangent.dot(b.tangent) > least_cosine;
}

const CirclePoint start{{{1, 0}}, {0, 1}};

TEST(Continuation, goes_all_round_through_both_folds) {
  CirclePoint here = start;
  double ds = 0.1;
  int folds = 0;
  // A step across the tangent turns by asin ds.
  const int steps = int(2 * std::numbers::pi / std::asin(ds));
  for (int i = 0; i < steps; ++i) {
    const auto next = arc_step(Circle{}, here, ds);
    ASSERT_TRUE(next) << i;
    EXPECT_NEAR(next->z.norm(), 1, 1e-13);
    EXPECT_NEAR(next->tangent.dot(here.tangent), std::sqrt(1 - ds * ds), 1e-12);
    folds += next->slope() * here.slope() < 0;
    here = *next;
  }
  EXPECT_EQ(folds, 2);
  EXPECT_LT((here.z - start.z).norm(), 0.1);
}

TEST(Continuation, locates_a_fold) {
  double ds = 0.4;
  CirclePoint before = start, beyond = start;
  while (beyond.slope() >= 0) {
    before = beyond;
    beyond = arc_step(Circle{}, before, ds).value();
  }
  const CirclePoint fold = locate_fold(Circle{}, before, beyond, ds);
  EXPECT_NEAR(fold.slope(), 0, Circle::limits.fold);
  EXPECT_NEAR(fold.z[1], 1, 1e-14);  // quadratic in the slope
}

TEST(Continuation, halves_a_step_that_leads_nowhere) {
  EXPECT_FALSE(arc_step(Circle{}, start, 2));  // beyond the circle
  double ds = 2;
  const auto next = advance(Circle{}, start, ds, 1e-3);
  ASSERT_TRUE(next);
  EXPECT_EQ(ds, 0.5);  // at 1 the tangent has turned too far
  double too_long = 2;
  EXPECT_FALSE(advance(Circle{}, start, too_long, 1.5));
}

TEST(Continuation, does_not_go_on_where_newtons_method_does_not_converge) {
  double x = 1;
  const ContinuationLimits limits{
      .most_iterations = 5, .tolerance = 1e-6, .far = 0.5, .fold = 1e-8};
  EXPECT_FALSE(converges(x, limits, [](double&) { return std::optional<double>(); }));
  EXPECT_FALSE(converges(x, limits, [](double&) { return std::optional(0.6); }));
  EXPECT_FALSE(converges(x, limits, [](double&) { return std::optional(1e-3); }));
  EXPECT_TRUE(converges(x, limits, [](double& y) { return std::optional(y *= 1e-2); }));
}

struct Cubic {
  using Solution = OnCircle;
  using Point = CirclePoint;
  static constexpr ContinuationLimits limits = Circle::limits;
  double epsilon;
};

std::optional<OnCircle> predicted(const Cubic&, const CirclePoint& from, double ds) {
  return OnCircle{from.z + ds * from.tangent};
}

std::optional<double> newton_step(const Cubic& c, OnCircle& at, const CirclePoint& from,
                                  double ds) {
  const double x = at.z[0];
  Eigen::Matrix2d matrix;
  matrix << -3 * x * x + c.epsilon, 1, from.tangent.transpose();
  const Eigen::Vector2d miss(at.z[1] - x * x * x + c.epsilon * x,
                             from.tangent.dot(at.z - from.z) - ds);
  const Eigen::Vector2d step = -matrix.partialPivLu().solve(miss);
  at.z += step;
  return step.norm();
}

std::optional<CirclePoint> with_tangent(const Cubic& c, const OnCircle& at,
                                        const Eigen::Vector2d* forward) {
  const Eigen::Vector2d t = Eigen::Vector2d(1, 3 * at.z[0] * at.z[0] - c.epsilon).normalized();
  return CirclePoint{at, t.dot(*forward) < 0 ? -t : t};
}

bool continues(const Cubic&, const CirclePoint& a, const CirclePoint& b, double) {
  return a.tangent.dot(b.tangent) > least_cosine;
}

TEST(Continuation, does_not_step_over_two_folds) {
  for (const double epsilon : {0.1, 0.03, 0.01, 0.003})  // 0.37 to 0.06 apart
    for (const double longest : {0.5, 0.3, 0.1, 0.03})
      for (const double x : {-1.01, -0.7, -0.33}) {
        const Cubic cubic{epsilon};
        const Eigen::Vector2d forward(1, 0);
        CirclePoint here = *with_tangent(cubic, {{x, x * x * x - epsilon * x}}, &forward);
        double ds = longest;
        int folds = 0;
        while (here.z[0] < 1) {
          const auto next = advance(cubic, here, ds, 1e-6);
          ASSERT_TRUE(next);
          folds += next->slope() * here.slope() < 0;
          here = *next;
          ds = std::min(1.5 * ds, longest);
        }
        EXPECT_EQ(folds, 2) << epsilon << ' ' << longest << ' ' << x;
      }
}

}  // namespace
}  // namespace sbeh::model
