#include "axisym/shooting/shooting_branch.h"

#include "model/numerics/root.h"

#include <Eigen/Dense>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace sbeh::axisym::shooting {
namespace {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;
using std::numbers::pi;

constexpr int most_steps = 500;  // of a walk

// The solution from one of the poles at the equator.
struct Half {
  End end;
  Eigen::Matrix<double, Row::count, Eigen::Dynamic> rates;  // by all of y
};

std::optional<Half> shoot(const VectorXd& y, const Pole& pole, Index H, Index length,
                          const Options& options) {
  constexpr double longest = 50;
  if (!(y[length] > options.series_start && y[length] < longest)) return std::nullopt;
  const auto end = integrate(pole, y[length], options);
  if (!end) return std::nullopt;
  Half half{*end, MatrixXd::Zero(Row::count, y.size())};
  half.rates.col(H) = end->rates.col(0);
  half.rates.col(Unknown::tension) = multiplier_unit * end->rates.col(1);
  half.rates.col(Unknown::pressure) = multiplier_unit * end->rates.col(2);
  half.rates.col(length) = end->rates.col(3);
  return half;
}

struct Closure {
  VectorXd residual;    // n - 1
  MatrixXd derivative;  // n - 1 x n
  State both;           // sum over the halves
  MatrixXd both_rates;
  double odd_closure;
};

std::optional<Closure> close(const VectorXd& y, const Options& options) {
  const auto one = shoot(y, pole(y), Unknown::H, Unknown::length, options);
  const auto two = is_symmetric(y)
                     ? one
                     : shoot(y, other_pole(y), Unknown::other_H, Unknown::other_length, options);
  if (!one || !two) return std::nullopt;
  const State &a = one->end.state, &b = two->end.state;
  const auto &da = one->rates, &db = two->rates;
  const Index n = y.size();
  Closure c{VectorXd(n - 1), MatrixXd(n - 1, n), a + b, da + db, one->end.rates(Row::X, 0)};

  Index i = 0;
  const auto require_zero = [&](double residual, const auto& derivative) {
    c.residual[i] = residual;
    c.derivative.row(i++) = derivative;
  };
  require_zero(a[Row::psi] - pi / 2, da.row(Row::psi));
  require_zero(c.both[Row::gamma], c.both_rates.row(Row::gamma));
  require_zero(c.both[Row::area] - 4 * pi, c.both_rates.row(Row::area));
  require_zero(
      c.both[Row::volume] - 4 * pi / 3 * y[Unknown::volume],
      c.both_rates.row(Row::volume) - 4 * pi / 3 * VectorXd::Unit(n, Unknown::volume).transpose());
  if (!is_symmetric(y)) {
    require_zero(b[Row::psi] - pi / 2, db.row(Row::psi));
    require_zero(a[Row::X] - b[Row::X], da.row(Row::X) - db.row(Row::X));
  }
  return c;
}

[[noreturn]] void lost(const Point& at) {
  throw std::runtime_error(
      fmt::format("shooting cannot follow the branch beyond reduced volume {:.6f}", at.volume()));
}

// Towards a volume on the tangent.
Point move_to_volume(const Point& from, double volume, const Options& options) {
  VectorXd guess = from.y + (volume - from.volume()) / from.slope() * from.tangent;
  const auto point = solve_at_volume(guess, options);
  if (!point) lost(from);
  return *point;
}

}  // namespace

Pole pole(const VectorXd& y) {
  return {y[Unknown::H], multiplier_unit * y[Unknown::tension],
          multiplier_unit * y[Unknown::pressure]};
}
Pole other_pole(const VectorXd& y) {
  Pole p = pole(y);
  if (!is_symmetric(y)) p.H = y[Unknown::other_H];
  return p;
}

std::optional<Point> solve(VectorXd y, const VectorXd& row, const Options& options) {
  constexpr double largest = 1, small_enough = 1e-12;
  constexpr double rounding = 1e-7;  // amplified near a fold in row · y
  const Index n = y.size();
  MatrixXd matrix(n, n);
  VectorXd rhs(n);
  for (double last = largest, size = 0;; last = size) {
    const auto c = close(y, options);
    if (!c) return std::nullopt;
    matrix << c->derivative, row.transpose();
    rhs << -c->residual, 0;
    const Eigen::PartialPivLU<MatrixXd> lu(matrix);
    const VectorXd dy = lu.solve(rhs);
    size = dy.norm();
    const bool shrinks = size < last / 2;
    if (!shrinks && !(size < rounding)) return std::nullopt;
    y += dy;
    if (size < small_enough || !shrinks) {
      const State both = c->both + c->both_rates * dy;
      const VectorXd tangent = lu.solve(VectorXd::Unit(n, n - 1));
      return Point{y, tangent.normalized(), both[Row::energy], both[Row::Z], c->odd_closure};
    }
  }
}

std::optional<Point> solve_at_volume(const VectorXd& guess, const Options& options) {
  return solve(guess, VectorXd::Unit(guess.size(), Unknown::volume), options);
}

std::optional<Point> step(const Point& from, double length, const Options& options) {
  constexpr double least_cosine = 0.8, longest_chord = 1.15;  // an arc that turns so has 1.06
  constexpr double rounding = 1e-9;
  auto to = solve(from.y + length * from.tangent, from.tangent, options);
  if (!to) return std::nullopt;
  const double cosine = to->tangent.dot(from.tangent), chord = (to->y - from.y).norm();
  if (cosine < 0) to->tangent *= -1;
  const bool smooth =
      std::abs(cosine) > least_cosine && chord <= longest_chord * std::abs(length) + rounding;
  return smooth ? to : std::nullopt;
}

Point find_zero(Point at, const Quantity& f, double offset, const Options& options) {
  constexpr int most_iterations = 20;
  constexpr double small_enough = 1e-9;  // the error left is far smaller
  double value = f(at);
  for (int iteration = 0; iteration < most_iterations; ++iteration) {
    const auto next = step(at, offset, options);
    if (!next) lost(at);
    const double next_value = f(*next);
    if (std::abs(offset) < small_enough || next_value == value) return *next;
    offset *= -next_value / (next_value - value);
    at = *next;
    value = next_value;
  }
  lost(at);
}

std::pair<Point, Point> find_crossing(Point a, Point b, const Options& options) {
  constexpr int most_iterations = 12;
  constexpr double small_enough = 1e-13;
  double volume = a.volume(), change = 1;
  for (int i = 0; i < most_iterations && std::abs(change) > small_enough; ++i) {
    a = move_to_volume(a, volume, options);
    b = move_to_volume(b, volume, options);
    change = -6 * (a.energy - b.energy) / (pole(a.y).pressure - pole(b.y).pressure);
    volume += change;
  }
  return {a, b};
}

Walk::Walk(Branch branch, const Point& start, const Options& options)
    : branch_(branch), at_(start), options_(options) {}

const Point& Walk::go_to(double volume) {
  if ((volume - at_.volume()) * at_.slope() < 0) at_.tangent *= -1;
  for (int steps = 0; steps < most_steps; ++steps) {
    const double estimate = std::abs((volume - at_.volume()) / at_.slope());
    Point next = advance(1.1 * estimate + 1e-6);
    const bool turns = next.slope() * at_.slope() <= 0;
    if (turns) {
      const double offset = (next.y - at_.y).norm() * at_.slope() / (at_.slope() - next.slope());
      next = find_zero(at_, &Point::slope, offset, options_);
    }
    const bool passes = (next.volume() - volume) * (at_.volume() - volume) <= 0;
    if (passes) return at_ = land(at_, next, volume);
    if (turns)
      throw NotOnBranch(fmt::format("no {} has reduced volume {}: the branch turns back at {:.9f}",
                                    name(branch_), volume, next.volume()));
    at_ = next;
  }
  lost(at_);
}

const Point& Walk::go_to_zero(const Quantity& f) {
  constexpr double longest = 1;
  for (int steps = 0; steps < most_steps; ++steps) {
    const Point next = advance(longest);
    const double here = f(at_), there = f(next);
    if (here * there <= 0) {
      const double offset = (next.y - at_.y).norm() * here / (here - there);
      return at_ = find_zero(at_, f, offset, options_);
    }
    at_ = next;
  }
  lost(at_);
}

Point Walk::advance(double longest) {
  constexpr double shortest = 1e-8, straight = 0.95;
  const double first = std::min(step_, longest);
  for (double length = first; length > shortest; length /= 2)
    if (const auto next = step(at_, length, options_)) {
      if (length < first)
        step_ = length;
      else if (length == step_ && next->tangent.dot(at_.tangent) > straight)
        step_ *= 1.5;
      return *next;
    }
  lost(at_);
}

// Between points with V_r monotonic: on Hermite's cubic first, then by Newton.
Point Walk::land(const Point& a, const Point& b, double volume) const {
  const double chord = (b.y - a.y).norm();
  const auto cubic = [&](double t) -> VectorXd {
    const double q = 1 - t;
    return q * q * (1 + 2 * t) * a.y + t * t * (1 + 2 * q) * b.y
         + t * q * chord * (q * a.tangent - t * b.tangent);
  };
  const auto miss = [&](double t) { return cubic(t)[Unknown::volume] - volume; };
  VectorXd guess = cubic(model::root_between(miss, 0, 1).middle());
  guess[Unknown::volume] = volume;
  auto point = solve_at_volume(guess, options_);
  if (!point || (point->y - guess).norm() > 0.5 * chord + 1e-6) lost(a);
  if (point->tangent.dot(a.tangent) < 0) point->tangent *= -1;
  if (point->slope() * a.slope() < 0) lost(a);
  return *point;
}

}  // namespace sbeh::axisym::shooting
