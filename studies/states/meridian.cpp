#include "studies/states/meridian.h"

#include "model/numerics/quadrature.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace sbeh::studies {

namespace {

constexpr int widest_window = 8;

const model::IntervalRule& rule() {
  static const model::IntervalRule gauss = model::gauss_rule(6);
  return gauss;
}

std::vector<int> element_joints(int elements) {
  std::vector<int> joints;
  for (int e = 1; e < elements; ++e) joints.push_back(3 * e);
  return joints;
}

// The coefficients of the even polynomial of t with these values at t = first, …, first + 3.
Eigen::Vector4d even_series(const Eigen::Vector4d& f, int first) {
  Eigen::Matrix4d powers;
  for (int i = 0; i < 4; ++i)
    for (int k = 0; k < 4; ++k) powers(i, k) = std::pow(double(first + i), 2 * k);
  return powers.lu().solve(f);
}

}  // namespace

Meridian::Meridian(const axisym::State& state)
    : Meridian(state.X, state.beta, element_joints(axisym::element_count(state.X))) {}

Meridian::Meridian(Eigen::Matrix2Xd points, Eigen::VectorXd order, const std::vector<int>& joints)
    : points_(std::move(points)), order_(std::move(order)), joints_{0} {
  joints_.insert(joints_.end(), joints.begin(), joints.end());
  joints_.push_back(size() - 1);
  bool ok = order_.size() == points_.cols();
  for (std::size_t k = 1; k < joints_.size(); ++k) ok = ok && joints_[k] - joints_[k - 1] >= 3;
  if (!ok)
    throw std::invalid_argument("meridian: needs four points in every piece, each with an order");
  lengths_ = Eigen::VectorXd::Zero(size());
  for (int i = 0; i + 1 < size(); ++i) lengths_[i + 1] = lengths_[i] + length_between(i, i + 1);
}

Meridian Meridian::centred() const {
  Meridian moved = *this;
  moved.points_.row(1).array() -= 0.5 * (points_(1, 0) + points_(1, size() - 1));
  return moved;
}

Meridian Meridian::reversed() const {
  Eigen::Matrix2Xd points = points_.rowwise().reverse();
  points.row(1) *= -1;
  std::vector<int> joints;
  for (std::size_t k = joints_.size() - 2; k > 0; --k) joints.push_back(size() - 1 - joints_[k]);
  return Meridian(points, order_.reverse(), joints);
}

Meridian::Window Meridian::window(double t) const {
  const auto above = std::upper_bound(joints_.begin() + 1, joints_.end() - 1, t);
  const int low = *(above - 1), high = *above;
  if (high - low + 1 <= widest_window) return {low, high - low + 1};
  int first = int(std::floor(t)) - widest_window / 2 + 1;
  // Poles can be passed, joints cannot.
  if (high != size() - 1) first = std::min(first, high + 1 - widest_window);
  if (low != 0) first = std::max(first, low);
  return {first, widest_window};
}

Eigen::Vector3d Meridian::node(int i) const {
  const int last = size() - 1;
  const int k = i < 0 ? -i : i > last ? 2 * last - i : i;
  return {k == i ? points_(0, k) : -points_(0, k), points_(1, k), order_[k]};
}

Eigen::Matrix<double, 3, 2> Meridian::evaluate(double t) const {
  const Window w = window(t);
  const double x = t - w.first;
  Eigen::Matrix<double, 3, 2> result = Eigen::Matrix<double, 3, 2>::Zero();
  for (int a = 0; a < w.count; ++a) {  // Lagrange's polynomials and their slopes
    double value = 1, slope = 0;
    for (int b = 0; b < w.count; ++b) {
      if (b == a) continue;
      slope = slope * (x - b) / (a - b) + value / (a - b);
      value *= (x - b) / (a - b);
    }
    result.col(0) += value * node(w.first + a);
    result.col(1) += slope * node(w.first + a);
  }
  return result;
}

Eigen::Vector2d Meridian::at(double t) const { return evaluate(t).topLeftCorner<2, 1>(); }
Eigen::Vector2d Meridian::tangent(double t) const { return evaluate(t).topRightCorner<2, 1>(); }

double Meridian::nearest(const Eigen::Vector2d& x) const {
  Eigen::Index start = 0;
  (points_.colwise() - x).colwise().squaredNorm().minCoeff(&start);
  const double low = std::max(0., double(start) - 1.5), high = std::min(size() - 1., start + 1.5);
  double t = double(start);
  for (int iteration = 0; iteration < 30; ++iteration) {
    const auto p = evaluate(t);
    const Eigen::Vector2d dx = p.topRightCorner<2, 1>();
    const double step = (x - p.topLeftCorner<2, 1>()).dot(dx) / dx.squaredNorm();
    t = std::clamp(t + step, low, high);
    if (std::abs(step) < 1e-13) break;
  }
  return t;
}

double Meridian::normal_distance(double t, const Eigen::Vector2d& x) const {
  const Eigen::Vector2d dx = tangent(t);
  return Eigen::Vector2d(-dx[1], dx[0]).normalized().dot(x - at(t));
}

double Meridian::length_between(double from, double to) const {
  double length = 0;
  for (int q = 0; q < rule().size(); ++q)
    length += rule().weights[q] * tangent(from + (to - from) * rule().points[q]).norm();
  return (to - from) * length;
}

double Meridian::arc_length(double t) const {
  const int i = std::min(int(t), size() - 2);
  return lengths_[i] + length_between(i, t);
}

double Meridian::mean_order() const {
  double sum = 0, area = 0;
  for (int i = 0; i + 1 < size(); ++i)
    for (int q = 0; q < rule().size(); ++q) {
      const auto p = evaluate(i + rule().points[q]);
      const double dS = rule().weights[q] * p(0, 0) * p.topRightCorner<2, 1>().norm();
      sum += p(2, 0) * dS;
      area += dS;
    }
  return sum / area;
}

double Meridian::largest_order() const {
  constexpr int parts = 16;
  double largest = order_.maxCoeff();
  for (int k = 1; k < parts * (size() - 1); ++k)
    largest = std::max(largest, evaluate(double(k) / parts)(2, 0));
  return largest;
}

std::array<double, 2> Meridian::pole_curvatures() const {
  std::array<double, 2> H{};
  for (const int pole : {0, 1}) {
    const int last = size() - 1;
    Eigen::Vector4d z, r_by_t;  // both even in t, counted from the pole
    for (int i = 0; i < 4; ++i) {
      z[i] = points_(1, pole == 0 ? i : last - i);
      r_by_t[i] = points_(0, pole == 0 ? i + 1 : last - i - 1) / (i + 1);
    }
    const double dr = even_series(r_by_t, 1)[0], half_d2z = even_series(z, 0)[1];
    H[std::size_t(pole)] = (pole == 0 ? 4 : -4) * half_d2z / (dr * dr);
  }
  return H;
}

double distance(const Eigen::Matrix2Xd& points, const Meridian& curve) {
  double largest = 0;
  for (const auto x : points.colwise())
    largest = std::max(largest, (curve.at(curve.nearest(x)) - x).norm());
  return largest;
}

double distance(const Meridian& a, const Meridian& b) {
  return std::max(distance(a.points(), b), distance(b.points(), a));
}

}  // namespace sbeh::studies
