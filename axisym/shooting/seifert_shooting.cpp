#include "axisym/shooting/seifert_shooting.h"

#include "model/numerics/profile.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <optional>
#include <stdexcept>

namespace sbeh::axisym {
namespace {

using namespace shooting;
using Eigen::Index, Eigen::Matrix2Xd, Eigen::VectorXd;
using std::numbers::pi;

// Where the branches start.

// The limit of oblates and prolates. There Σ and P are such that the l = 2 mode costs nothing: −W₂ goes with such a mode
// like 2A, so that Σ + H₀²/2 + 2H₀ is −6.
VectorXd sphere(double H0) {
  const double tension = -6 - 2 * H0 - H0 * H0 / 2, pressure = -12 - 2 * H0;
  return VectorXd{{-2, pi / 2, tension / multiplier_unit, pressure / multiplier_unit, 1}};
}

// r = 1 + u Y₂ has the excess area 2u² = (8π/3)(1 − V_r), and H = −2 − 4u Y₂ at the pole.
Point near_sphere(Branch branch, const Options& options) {
  const double volume = 0.99;
  const double u = std::sqrt(4 * pi / 3 * (1 - volume)), Y2 = std::sqrt(5 / (4 * pi));
  VectorXd guess = sphere(options.H0);
  guess[Unknown::H] -= (branch == Branch::prolate ? 4 : -4) * u * Y2;
  guess[Unknown::volume] = volume;
  auto point = solve(guess, VectorXd::Unit(symmetric_size, Unknown::H), options);
  if (!point) throw std::runtime_error("shooting: no shape near the sphere");
  if (point->slope() > 0) point->tangent *= -1;
  return *point;
}

// Deviations from the sphere grow with the root of 1 − V_r.
Point between_sphere_and(const Point& start, double volume, const Options& options) {
  const double ratio = std::sqrt((1 - volume) / (1 - start.volume()));
  const VectorXd limit = sphere(options.H0);
  VectorXd guess = limit + ratio * (start.y - limit);
  guess[Unknown::volume] = volume;
  const auto point = solve_at_volume(guess, options);
  if (!point) throw std::runtime_error("shooting: no shape between the sphere and its neighbour");
  return *point;
}

// On the branch of odd perturbations, a little off the shape that loses its symmetry. Empty where none is: odd_closure
// vanishes too where the equator of a prolate ceases to bulge.
std::optional<Point> branch_off(const Point& symmetric, const Options& options) {
  constexpr double amplitude = 0.15;  // in H
  VectorXd guess(full_size), odd = VectorXd::Zero(full_size);
  guess << symmetric.y, symmetric.y[Unknown::H], symmetric.y[Unknown::length];
  odd[Unknown::H] = 1;
  odd[Unknown::other_H] = -1;
  auto point = solve(guess + amplitude * odd, odd, options);
  if (point && point->tangent.dot(odd) < 0) point->tangent *= -1;
  return point;
}

double symmetry_loss(const Point& p) { return p.odd_closure; }
double fold(const Point& p) { return p.slope(); }
double self_contact(const Point& p) { return p.pole_distance; }

// With the tangent from the oblates on.
Point walk_to_fold(const Point& oblate_at_symmetry_loss, const Options& options) {
  const auto start = branch_off(oblate_at_symmetry_loss, options);
  if (!start) throw std::runtime_error("shooting: found no stomatocyte next to the oblates");
  Walk walk(Branch::stomatocyte, *start, options);
  return walk.go_to_zero(fold);
}

Walk walk_beyond(const Point& fold, const Options& options) {
  const auto start = step(fold, 0.1, options);
  if (!start) throw std::runtime_error("shooting: found no stomatocyte beyond the fold");
  return {Branch::stomatocyte, *start, options};
}

Walk walk_from_sphere(Branch branch, const Options& options) {
  return {branch, near_sphere(branch, options), options};
}

Walk first_walk(Branch branch, const Options& options) {
  if (branch != Branch::stomatocyte) return walk_from_sphere(branch, options);
  Walk oblates = walk_from_sphere(Branch::oblate, options);
  return walk_beyond(walk_to_fold(oblates.go_to_zero(symmetry_loss), options), options);
}

// Results.

// From the pole to the equator at z = 0.
Matrix2Xd half_profile(const Pole& pole, double arc_length, const Options& options) {
  constexpr int intervals = 128;
  const auto states = sample(pole, arc_length, intervals, options);
  Matrix2Xd p(2, intervals + 1);
  p.row(0) = states.row(Row::X);
  p.row(1) = states(Row::Z, intervals) - states.row(Row::Z).array();
  return p;
}

Matrix2Xd profile(const VectorXd& y, const Options& options) {
  const Matrix2Xd upper = half_profile(pole(y), y[Unknown::length], options);
  Matrix2Xd lower =
      is_symmetric(y) ? upper : half_profile(other_pole(y), y[Unknown::other_length], options);
  lower.row(1) *= -1;
  const Index n = upper.cols() - 1;
  Matrix2Xd whole(2, 2 * n + 1);
  whole << upper, lower.leftCols(n).rowwise().reverse();
  return whole;
}

ClassicalShape shape_of(Branch branch, const VectorXd& y, double energy, const Options& options) {
  const Matrix2Xd curve = profile(y, options);
  return {.branch = branch,
          .reduced_volume = y[Unknown::volume],
          .energy = energy,
          .H_pole = pole(y).H,  // the larger one: branch_off() makes it so
          .pressure = pole(y).pressure,
          .tension = pole(y).tension,
          .self_contact = model::meets_itself(curve),
          .profile = curve};
}

void validate(double reduced_volume) {
  constexpr double nearest = 1 - 1e-7;  // nearer to the sphere rounding grows in Σ and P
  if (!(reduced_volume > 0 && (reduced_volume <= nearest || reduced_volume == 1)))
    throw std::invalid_argument(
        fmt::format("shooting: reduced volume {} must be in (0, 1 - 1e-7], or 1", reduced_volume));
}

SpecialPoint special_point(const Point& fine, const Point& coarse) {
  constexpr double rounding = 1e-12;
  return {fine.volume(), fine.energy, std::abs(fine.volume() - coarse.volume()) + rounding};
}

}  // namespace

std::vector<ClassicalShape> shoot_branch(Branch branch, std::span<const double> reduced_volumes,
                                         const ShootingOptions& options) {
  validate(options);
  for (const double volume : reduced_volumes) validate(volume);
  Walk walk = first_walk(branch, options);
  const bool from_sphere = branch != Branch::stomatocyte;
  const Point start = walk.at();

  std::vector<ClassicalShape> shapes;
  for (const double volume : reduced_volumes) {
    if (from_sphere && volume == 1) {
      shapes.push_back(
          shape_of(branch, sphere(options.H0), std::pow(1 + options.H0 / 2, 2), options));
    } else {
      const Point p = from_sphere && volume > start.volume()
                        ? between_sphere_and(start, volume, options)
                        : walk.go_to(volume);
      shapes.push_back(shape_of(branch, p.y, p.energy, options));
    }
  }
  return shapes;
}

namespace {

Options coarser(const Options& options) {
  return {100 * options.tolerance, 10 * options.series_start, options.H0};
}

}  // namespace

LossAndFold shoot_symmetry_loss(Branch branch, const ShootingOptions& options) {
  validate(options);
  Walk symmetric = walk_from_sphere(branch, options);
  Point loss = symmetric.go_to_zero(symmetry_loss);
  if (!branch_off(loss, options)) {
    constexpr double aside = 0.01;
    symmetric.go_to(loss.volume() - aside);
    loss = symmetric.go_to_zero(symmetry_loss);
  }
  const Point turn = walk_to_fold(loss, options);
  const auto zero = [&](const Point& p, const Quantity& f) {
    return special_point(p, find_zero(p, f, 1e-3, coarser(options)));
  };
  return {zero(loss, symmetry_loss), zero(turn, fold)};
}

SpecialPoints shoot_special_points(const ShootingOptions& options) {
  validate(options);
  Walk prolates = walk_from_sphere(Branch::prolate, options);
  Walk oblates = walk_from_sphere(Branch::oblate, options);
  const auto prolate_oblate = find_crossing(prolates.go_to(0.65), oblates.go_to(0.65), options);
  const Point oblate = oblates.go_to(0.59);
  const Point contact = Walk(oblates).go_to_zero(self_contact);
  const Point loss = oblates.go_to_zero(symmetry_loss);
  const Point turn = walk_to_fold(loss, options);
  Walk stomatocytes = walk_beyond(turn, options);
  const auto oblate_stomatocyte = find_crossing(oblate, stomatocytes.go_to(0.59), options);

  const Options coarse = coarser(options);
  const auto crossing = [&](const std::pair<Point, Point>& p) {
    return special_point(p.first, find_crossing(p.first, p.second, coarse).first);
  };
  const auto zero = [&](const Point& p, const Quantity& f) {
    return special_point(p, find_zero(p, f, 1e-3, coarse));
  };
  return {.prolate_oblate = crossing(prolate_oblate),
          .oblate_stomatocyte = crossing(oblate_stomatocyte),
          .stomatocyte_fold = zero(turn, fold),
          .oblate_symmetry_loss = zero(loss, symmetry_loss),
          .oblate_self_contact = zero(contact, self_contact)};
}

}  // namespace sbeh::axisym
