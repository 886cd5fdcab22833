// Pseudo-arclength continuation: a branch of solutions of a problem with one parameter is followed by its
// own length, so that folds, where the parameter turns back, are no obstacle.
#pragma once

#include <algorithm>
#include <cmath>
#include <concepts>
#include <optional>

namespace sbeh::model {

struct ContinuationLimits {
  int most_iterations;  ///< of Newton's method: more mean that the prediction was not on the branch
  double tolerance;     ///< on the last change; the error left is about its square
  double far;           ///< a larger change leaves the neighbourhood
  double fold;          ///< a smaller |slope| is that of a fold
  double growth = 2;    ///< a change so much larger than the one before does not converge
};

/// A problem whose solutions form branches. `System::Solution` holds the parameter too; `System::Point` is
/// a Solution with the unit tangent of its branch; slope() is the parameter's part of it, 0 at a fold.
///   predicted     at distance ds along the tangent of p; empty where there is nothing to look for
///   newton_step   moves x on the hyperplane there, across the tangent: the largest change, empty where it fails
///   with_tangent  pointing forward as that of p
///   continues     whether the second can be ds further on the part of the first, and is no other that Newton's
///                 method has jumped to; a weak test is least_cosine between their tangents
template <class System>
concept ContinuationSystem = requires(const System& system, const typename System::Point& p,
                                      typename System::Solution& x, double ds) {
  { predicted(system, p, ds) } -> std::same_as<std::optional<typename System::Solution>>;
  { newton_step(system, x, p, ds) } -> std::same_as<std::optional<double>>;
  { with_tangent(system, x, &p.tangent) } -> std::same_as<std::optional<typename System::Point>>;
  { continues(system, p, p, ds) } -> std::same_as<bool>;
  { p.parameter() } -> std::same_as<double>;
  { p.slope() } -> std::same_as<double>;
};

/// Between the tangents of a step: more turning means a jump.
inline constexpr double least_cosine = 0.6;

/// Repeats steps that return their largest change. False unless they converge.
template <class Solution, class Step>
bool converges(Solution& x, const ContinuationLimits& limits, Step&& step) {
  double bound = limits.far;
  for (int iteration = 0; iteration < limits.most_iterations; ++iteration) {
    const std::optional<double> change = step(x);
    if (!change || !(*change < bound)) return false;
    if (*change < limits.tolerance) return true;
    if (iteration > 0) bound = limits.growth * *change;
  }
  return false;
}

/// Whether the parameter may turn back and forth again between two points ds apart: by the cubic through them with
/// their slopes, whose own slope falls to a quarter of those at the ends. Folds much nearer to each other than ds are
/// not seen.
template <class Point>
bool may_hide_folds(const Point& from, const Point& next, double ds) {
  constexpr double share = 0.25, noise = 1e-9;  // of the parameter
  if (from.slope() * next.slope() <= 0) return false;
  const double first = std::abs(from.slope()), last = std::abs(next.slope());
  const double mean = std::abs((next.parameter() - from.parameter()) / ds);
  const double bend = 3 * (first + last - 2 * mean), rise = last - first - bend;
  if (bend <= 0 || rise >= 0 || rise <= -2 * bend) return false;  // the least slope is at an end
  const double least = first - rise * rise / (4 * bend);
  return least < share * std::min(first, last) - noise / std::abs(ds);
}

/// The point ds further. Empty when Newton's method does not converge in a few iterations, or jumps, and where
/// the step may hide two folds.
template <ContinuationSystem System>
std::optional<typename System::Point> arc_step(const System& system,
                                               const typename System::Point& from, double ds) {
  auto x = predicted(system, from, ds);
  if (!x
      || !converges(*x, System::limits, [&](auto& s) { return newton_step(system, s, from, ds); }))
    return {};
  auto next = with_tangent(system, *x, &from.tangent);
  if (!next || !continues(system, from, *next, ds) || may_hide_folds(from, *next, ds)) return {};
  return next;
}

/// The point at the longest of ds, ds/2, … > shortest that leads to one; ds becomes that length.
template <ContinuationSystem System>
std::optional<typename System::Point> advance(const System& system,
                                              const typename System::Point& from, double& ds,
                                              double shortest) {
  for (; ds > shortest; ds /= 2)
    if (auto next = arc_step(system, from, ds)) return next;
  return {};
}

/// The fold between a point and the one ds further, where the slope changes sign: its zero, by secants that
/// move on from the nearest point before the fold.
template <ContinuationSystem System>
typename System::Point locate_fold(const System& system, const typename System::Point& start,
                                   const typename System::Point& beyond, double ds) {
  using Point = typename System::Point;
  constexpr int most_iterations = 40;
  constexpr double shortest = 1e-12;
  Point before = start, best = beyond;
  const double sign = start.slope() < 0 ? -1 : 1;  // before the fold
  const auto slope = [sign](const Point& p) { return sign * p.slope(); };
  double h = ds * slope(before) / (slope(before) - slope(beyond));
  for (int i = 0;
       i < most_iterations && std::abs(slope(best)) > System::limits.fold && h > shortest; ++i) {
    const auto next = arc_step(system, before, h);
    if (!next) {
      h /= 2;
      continue;
    }
    if (std::abs(slope(*next)) < std::abs(slope(best))) best = *next;
    const double zero = h * slope(before) / (slope(before) - slope(*next));
    if (slope(*next) > 0) {  // not there yet: go on from the nearer point
      before = *next;
      h = std::max(zero - h, shortest);
    } else {
      h = zero;
    }
  }
  return best;
}

}  // namespace sbeh::model
