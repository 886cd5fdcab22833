#include "meshing/revolution.h"

#include "meshing/even_mesh.h"

#include <boost/math/tools/roots.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <utility>

namespace sbeh::meshing {

using Eigen::Vector2d;
using Eigen::Vector3d;

namespace {

constexpr int samples_per_element = 6;

// The cubic through four equidistant values at x in [0, 1], and two derivatives.
template <class Value>
struct Cubic {
  Value a, b, c, d;  // a + bx + cx² + dx³
  Cubic(const Value& p0, const Value& p1, const Value& p2, const Value& p3)
      : a(p0),
        b(-5.5 * p0 + 9 * p1 - 4.5 * p2 + p3),
        c(9 * p0 - 22.5 * p1 + 18 * p2 - 4.5 * p3),
        d(-4.5 * p0 + 13.5 * p1 - 13.5 * p2 + 4.5 * p3) {}
  Value value(double x) const { return a + x * (b + x * (c + x * d)); }
  Value slope(double x) const { return b + x * (2 * c + 3 * x * d); }
  Value bend(double x) const { return 2 * c + 6 * x * d; }
};

Cubic<Vector2d> element(const Eigen::Matrix2Xd& X, int e) {
  return {X.col(3 * e), X.col(3 * e + 1), X.col(3 * e + 2), X.col(3 * e + 3)};
}

void validate(const Profile& profile) {
  const auto& [X, beta] = profile;
  const Eigen::Index nodes = X.cols();
  if (nodes < 4 || nodes % 3 != 1)
    throw std::invalid_argument(
        fmt::format("profile: {} nodes: must be 3 for each element and one, at least 4", nodes));
  if (beta.size() != 0 && beta.size() != nodes)
    throw std::invalid_argument(
        fmt::format("profile: {} nodes, but {} values of the order", nodes, beta.size()));
  if (beta.size() != 0 && !beta.allFinite())
    throw std::invalid_argument("profile: the order must be finite numbers");
  for (Eigen::Index i = 0; i < nodes; ++i) {
    const double r = X(0, i), z = X(1, i);
    const bool pole = i == 0 || i == nodes - 1;
    if (!(std::isfinite(r) && std::isfinite(z) && (pole ? r == 0 : r > 0)))
      throw std::invalid_argument(fmt::format("profile: node {} at r = {}, z = {}: must have {}", i,
                                              r, z, pole ? "r = 0 at a pole" : "r > 0"));
  }
}

}  // namespace

ProfileCurve::ProfileCurve(const Profile& profile) : profile_(profile) {
  const int count = samples_per_element * model::element_count(profile_.X);
  samples_.resize(2, count + 1);
  area_ = Eigen::VectorXd::Zero(count + 1);
  for (int k = 0; k <= count; ++k) samples_.col(k) = at(double(k) / samples_per_element);
  for (int k = 1; k <= count; ++k)
    area_[k] =
        area_[k - 1]
        + (samples_.col(k) - samples_.col(k - 1)).norm() * (samples_(0, k) + samples_(0, k - 1));
  area_ /= area_[count];
}

Vector2d ProfileCurve::at(double t) const {
  const int e = std::clamp(int(t), 0, model::element_count(profile_.X) - 1);
  Vector2d x = element(profile_.X, e).value(t - e);
  if (t <= 0 || t >= model::element_count(profile_.X)) x[0] = 0;  // not rounded
  return x;
}

double ProfileCurve::beta_at(double t) const {
  const int e = std::clamp(int(t), 0, model::element_count(profile_.X) - 1);
  const auto& b = profile_.beta;
  return Cubic<double>(b[3 * e], b[3 * e + 1], b[3 * e + 2], b[3 * e + 3]).value(t - e);
}

double ProfileCurve::nearest_between(double low, double high, const Vector2d& x) const {
  const int e = std::min(int((low + high) / 2), model::element_count(profile_.X) - 1);
  const auto curve = element(profile_.X, e);
  // Half the derivative of the squared distance, and its derivative.
  const auto slope = [&](double t) {
    const Vector2d off = curve.value(t - e) - x, along = curve.slope(t - e);
    return std::pair(off.dot(along), along.squaredNorm() + off.dot(curve.bend(t - e)));
  };
  if (slope(low).first >= 0) return low;
  if (slope(high).first <= 0) return high;
  constexpr int bits = 50;
  std::uintmax_t iterations = 60;
  return boost::math::tools::newton_raphson_iterate(slope, (low + high) / 2, low, high, bits,
                                                    iterations);
}

double ProfileCurve::nearest(const Vector2d& x) const {
  Eigen::Index k = 0;
  (samples_.colwise() - x).colwise().squaredNorm().minCoeff(&k);
  double best = double(k) / samples_per_element, distance = (samples_.col(k) - x).norm();
  const auto try_between = [&](Eigen::Index from) {
    if (from < 0 || from + 1 >= samples_.cols()) return;
    const double t = nearest_between(double(from) / samples_per_element,
                                     double(from + 1) / samples_per_element, x);
    const double d = (at(t) - x).norm();
    if (d < distance) {
      best = t;
      distance = d;
    }
  };
  try_between(k - 1);
  try_between(k);
  return best;
}

double ProfileCurve::at_area(double fraction) const {
  if (fraction <= 0) return 0;
  if (fraction >= 1) return model::element_count(profile_.X);
  const auto* above = std::upper_bound(area_.data(), area_.data() + area_.size(), fraction);
  const auto k = Eigen::Index(above - area_.data());
  const double part = (fraction - area_[k - 1]) / (area_[k] - area_[k - 1]);
  return (double(k - 1) + part) / samples_per_element;
}

RevolvedMesh revolved(const Profile& profile, const Resolution& resolution) {
  resolution.validate();
  Profile down = profile;  // from the north pole to the south pole
  validate(down);
  if (down.X(1, 0) < down.X(1, down.X.cols() - 1)) {
    down.X = down.X.rowwise().reverse().eval();
    down.beta = down.beta.reverse().eval();
  }
  const ProfileCurve curve(down);
  const auto in_plane = [](const Vector3d& x) { return Vector2d(std::hypot(x[0], x[1]), x[2]); };
  const auto turned = [](const Vector2d& rz, const Vector3d& x) -> Vector3d {
    const double rho = std::hypot(x[0], x[1]);
    if (rho == 0) return {rz[0], 0, rz[1]};
    return {rz[0] * (x[0] / rho), rz[0] * (x[1] / rho), rz[1]};
  };
  const Projection onto_profile = [&](const Vector3d& x) {
    return turned(curve.at(curve.nearest(in_plane(x))), x);
  };
  // The sphere's latitudes go where the surface has the same share of its area.
  const Projection from_sphere = [&](const Vector3d& d) {
    return turned(curve.at(curve.at_area((1 - d.z()) / 2)), d);
  };
  RevolvedMesh result{.mesh = even_mesh(resolution, from_sphere, onto_profile), .beta = {}};
  if (down.beta.size() == 0) return result;
  result.beta.resize(result.mesh.node_count());
  for (int i = 0; i < result.mesh.node_count(); ++i)
    result.beta[i] = curve.beta_at(curve.nearest(in_plane(result.mesh.nodes.col(i))));
  return result;
}

}  // namespace sbeh::meshing
