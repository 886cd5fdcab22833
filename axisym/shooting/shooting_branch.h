// Closed shapes from the solutions of the shape equations, and their branches.
//
// Closure at the equator, ψ = π/2. Symmetric shapes: unknowns H at the pole, arc length, Σ, P;
//   ψ = π/2,  γ = 0,  A = 2π,  V = (2π/3) V_r.
// Others: H at both poles, both arc lengths, Σ, P; with the solutions from the poles marked 1 and 2,
//   ψ₁ = ψ₂ = π/2,  X₁ = X₂,  γ₁ + γ₂ = 0,  A₁ + A₂ = 4π,  V₁ + V₂ = (4π/3) V_r.
// h = 0 then matches H² too.
#pragma once

#include "axisym/classical_shape.h"
#include "axisym/shooting/shape_equations.h"

#include <functional>
#include <optional>
#include <stdexcept>
#include <utility>

namespace sbeh::axisym::shooting {

/// Unknowns and the reduced volume, all of the same size: Σ and P are in units of `multiplier_unit`.
/// Symmetric shapes have the first five.
struct Unknown {
  enum : Eigen::Index { H, length, tension, pressure, volume, other_H, other_length };
};
constexpr Eigen::Index symmetric_size = 5, full_size = 7;
constexpr double multiplier_unit = 10;

inline bool is_symmetric(const Eigen::VectorXd& y) { return y.size() == symmetric_size; }
Pole pole(const Eigen::VectorXd& y);
Pole other_pole(const Eigen::VectorXd& y);

/// A shape on a branch.
struct Point {
  Eigen::VectorXd y;
  Eigen::VectorXd tangent;  // of the branch, unit, either way
  double energy;            ///< F/(8πκ)
  double pole_distance;     ///< negative where the poles have passed each other
  /// ∂X/∂H at the equator. A perturbation of a symmetric shape that is odd from pole to pole leaves Σ
  /// and P alone, and closes where this is 0 (as long as ψ' is not).
  double odd_closure;

  double volume() const { return y[Unknown::volume]; }
  double slope() const { return tangent[Unknown::volume]; }  ///< 0 at a fold
};

/// Newton's method for the closure at fixed row · y. Nothing unless every correction is less than
/// half of the last: a guess that is too far off must not wander to another branch.
std::optional<Point> solve(Eigen::VectorXd guess, const Eigen::VectorXd& row,
                           const Options& options);
/// The same at the reduced volume of the guess.
std::optional<Point> solve_at_volume(const Eigen::VectorXd& guess, const Options& options);

/// A step of this length along the tangent, and back to the branch at a right angle. Nothing if the
/// end is not on the same smooth curve; its tangent has the same sense.
std::optional<Point> step(const Point& from, double length, const Options& options);

using Quantity = std::function<double(const Point&)>;

/// The zero of f about `offset` along the branch; secant method.
Point find_zero(Point from, const Quantity& f, double offset, const Options& options);

/// Where two branches have equal energies, from points nearby; Newton, by d(energy)/dV_r = P/6.
std::pair<Point, Point> find_crossing(Point a, Point b, const Options& options);

/// A shape that its branch does not have; the text says where the branch turns back.
struct NotOnBranch : std::domain_error {
  using std::domain_error::domain_error;
};

/// A walk along a branch by steps that see folds and do not leave the branch.
/// Throws std::runtime_error where shooting cannot follow.
class Walk {
 public:
  Walk(Branch branch, const Point& start, const Options& options);

  const Point& at() const { return at_; }
  /// Straight to the reduced volume. Throws NotOnBranch if a fold comes first.
  const Point& go_to(double volume);
  /// Along the tangent to the next zero of f.
  const Point& go_to_zero(const Quantity& f);

 private:
  Point advance(double longest);
  Point land(const Point& a, const Point& b, double volume) const;

  Branch branch_;
  Point at_;
  Options options_;
  double step_ = 0.3;
};

}  // namespace sbeh::axisym::shooting
