// The meridian of a surface of revolution: a smooth curve through the points of a profile.
//
// Places on it are numbers t in [0, points − 1]: point ⌊t⌋ and what follows. Between points the curve is a
// polynomial in t, that of an element or the one through the eight points around; beyond a pole it goes on
// as its mirror image.
#pragma once

#include "axisym/curve.h"

#include <Eigen/Core>

#include <array>
#include <vector>

namespace sbeh::studies {

class Meridian {
 public:
  /// The P3 elements of a state of the axisymmetric solver.
  explicit Meridian(const axisym::State& state);
  /// Points r, z from pole to pole (2 x n) with the order there (n). Their spacing is smooth but at the
  /// joints, indices of points in ascending order, without the ends. Throws std::invalid_argument unless
  /// there are four points in every piece and an order for every point.
  Meridian(Eigen::Matrix2Xd points, Eigen::VectorXd order, const std::vector<int>& joints = {});

  const Eigen::Matrix2Xd& points() const { return points_; }  // 2 x n: r, z
  const Eigen::VectorXd& order() const { return order_; }     // n

  /// Moved along the axis so that z = 0 halfway between the poles.
  Meridian centred() const;
  /// Turned over: from the other pole on.
  Meridian reversed() const;

  Eigen::Vector2d at(double t) const;
  /// dX/dt
  Eigen::Vector2d tangent(double t) const;
  /// Place of the point nearest to (r, z).
  double nearest(const Eigen::Vector2d& x) const;
  /// Distance of (r, z) from the point at t along the outward normal there.
  double normal_distance(double t, const Eigen::Vector2d& x) const;
  /// From the first pole on.
  double arc_length(double t) const;

  /// Mean of the order over the surface.
  double mean_order() const;
  /// Largest order, between the points too.
  double largest_order() const;
  /// H at either pole (−2 on the unit sphere) by the even polynomial through the four points next to it;
  /// for points of smooth spacing.
  std::array<double, 2> pole_curvatures() const;

 private:
  // The polynomial that holds around t: its first point, which may lie beyond a pole, and how many.
  struct Window {
    int first, count;
  };
  Window window(double t) const;
  Eigen::Vector3d node(int i) const;  // r, z, order; mirrored beyond the poles
  // r, z, order and their derivatives by t.
  Eigen::Matrix<double, 3, 2> evaluate(double t) const;
  double length_between(double from, double to) const;  // within one interval
  int size() const { return int(points_.cols()); }

  Eigen::Matrix2Xd points_;
  Eigen::VectorXd order_;
  std::vector<int> joints_;  // both ends included
  Eigen::VectorXd lengths_;  // n: arc length at the points
};

/// Largest distance of points r, z (2 x n) from the curve; of the points of either from the other.
double distance(const Eigen::Matrix2Xd& points, const Meridian& curve);
double distance(const Meridian& a, const Meridian& b);

}  // namespace sbeh::studies
