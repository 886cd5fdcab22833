#include "axisym/shape_class.h"

#include "model/numerics/profile.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace sbeh::axisym {

namespace {

constexpr int pieces = 9;                 // of an element
constexpr double asymmetry_limit = 1e-3;  // above it a shape counts as not symmetric

Eigen::Matrix2Xd polygon(const Nodes& X) {
  Eigen::Matrix2Xd points(2, pieces * element_count(X) + 1);
  for (int e = 0; e < element_count(X); ++e)
    for (int k = 0; k < pieces; ++k)
      points.col(pieces * e + k) = curve_point(X, e, even_points<pieces>()[std::size_t(k)]).x;
  points.col(points.cols() - 1) = X.col(X.cols() - 1);
  return points;
}

// Largest difference of r at equal arc length from either pole, in radii of the sphere of equal area.
double asymmetry(const Nodes& X) {
  const Eigen::Matrix2Xd p = polygon(X);
  const Eigen::Index n = p.cols();
  std::vector<double> s(std::size_t(n), 0.);
  for (Eigen::Index i = 1; i < n; ++i)
    s[std::size_t(i)] = s[std::size_t(i) - 1] + (p.col(i) - p.col(i - 1)).norm();
  const auto radius = [&](double at) {
    const auto above = std::upper_bound(s.begin() + 1, s.end() - 1, at);
    const auto k = std::size_t(above - s.begin());
    const double share = (at - s[k - 1]) / (s[k] - s[k - 1]);
    return (1 - share) * p(0, Eigen::Index(k) - 1) + share * p(0, Eigen::Index(k));
  };
  double largest = 0;
  for (Eigen::Index i = 0; i < n; ++i)
    largest = std::max(largest, std::abs(p(0, i) - radius(s.back() - s[std::size_t(i)])));
  return largest;
}

}  // namespace

ShapeClass classify(const Nodes& X) {
  const double width = 2 * X.row(0).maxCoeff();
  const double poles = X(1, 0) - X(1, X.cols() - 1);
  const bool flat = poles < width;
  if (asymmetry(X) < asymmetry_limit) return flat ? ShapeClass::oblate : ShapeClass::prolate;
  const double dent =
      std::max(X.row(1).maxCoeff() - X(1, 0), X(1, X.cols() - 1) - X.row(1).minCoeff());
  return dent > asymmetry_limit ? ShapeClass::stomatocyte : ShapeClass::pear;
}

namespace {

// The largest radius from a node on in steps of ±1, before the curve comes nearer to the axis than there.
double widest_beside(const Nodes& X, Eigen::Index node, Eigen::Index step) {
  double widest = X(0, node);
  for (Eigen::Index i = node; i >= 0 && i < X.cols() && X(0, i) >= X(0, node); i += step)
    widest = std::max(widest, X(0, i));
  return widest;
}

}  // namespace

std::vector<Neck> necks(const Nodes& X) {
  std::vector<Neck> found;
  for (Eigen::Index i = 1; i + 1 < X.cols(); ++i) {
    const double a = X(0, i);
    if (!(a < X(0, i - 1) && a <= X(0, i + 1))) continue;
    const double beside = std::min(widest_beside(X, i, -1), widest_beside(X, i, 1));
    found.push_back({i, a, 1 - a / beside});
  }
  return found;
}

double thinnest_neck(const Nodes& X) {
  double radius = std::numeric_limits<double>::infinity();
  for (const Neck& neck : necks(X)) radius = std::min(radius, neck.radius);
  return radius;
}

bool crosses_itself(const Nodes& X) {
  const Eigen::Matrix2Xd p = polygon(X);
  return p.row(0).segment(1, p.cols() - 2).minCoeff() <= 0 || model::meets_itself(p);
}

}  // namespace sbeh::axisym
