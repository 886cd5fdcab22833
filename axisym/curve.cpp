#include "axisym/curve.h"

#include "model/numerics/lagrange.h"
#include "model/numerics/quadrature.h"

#include <cmath>
#include <numbers>
#include <vector>

namespace sbeh::axisym {

using std::numbers::pi;

ShapeValues shape_values(double x) {
  static const model::IntervalElement cubic(3), quadratic(2);
  ShapeValues s{.x = x, .weight = 0, .phi = {}, .dphi = {}, .phi2 = {}};
  Eigen::Map<Eigen::Vector4d>(s.phi.data()) = cubic.values(x);
  Eigen::Map<Eigen::Vector4d>(s.dphi.data()) = cubic.derivatives(x);
  Eigen::Map<Eigen::Vector3d>(s.phi2.data()) = quadratic.values(x);
  return s;
}

namespace {
std::vector<ShapeValues> tabulate(int points) {
  const model::IntervalRule rule = model::gauss_rule(points);
  std::vector<ShapeValues> table;
  for (int q = 0; q < points; ++q) {
    table.push_back(shape_values(rule.points[q]));
    table.back().weight = rule.weights[q];
  }
  return table;
}
}  // namespace

std::span<const ShapeValues> assembly_points() {
  static const std::vector<ShapeValues> table = tabulate(6);
  return table;
}

std::span<const ShapeValues> diagnostic_points() {
  static const std::vector<ShapeValues> table = tabulate(10);
  return table;
}

CurvePoint curve_point(const Nodes& X, int e, const ShapeValues& s) {
  CurvePoint p;
  p.x.setZero();
  p.dx.setZero();
  for (int a = 0; a < 4; ++a) {
    p.x += s.phi[a] * X.col(3 * e + a);
    p.dx += s.dphi[a] * X.col(3 * e + a);
  }
  p.stretch = p.dx.norm();
  p.t = p.dx / p.stretch;
  p.nu << -p.t[1], p.t[0];
  p.B_phi = -p.nu[0] / p.x[0];
  p.dS = 2 * pi * p.x[0] * p.stretch * s.weight;
  return p;
}

Nodes node_normals(const Nodes& X) {
  static const std::array<ShapeValues, 4> at_nodes{shape_values(0), shape_values(1. / 3),
                                                   shape_values(2. / 3), shape_values(1)};
  Nodes n = Nodes::Zero(2, X.cols());
  for (int e = 0; e < element_count(X); ++e)
    for (int a = 0; a < 4; ++a) {
      Eigen::Vector2d dx = Eigen::Vector2d::Zero();
      for (int b = 0; b < 4; ++b) dx += at_nodes[a].dphi[b] * X.col(3 * e + b);
      n.col(3 * e + a) += Eigen::Vector2d(-dx[1], dx[0]).normalized();
    }
  n.colwise().normalize();
  const Eigen::Index last = X.cols() - 1;
  n.col(0) << 0, std::copysign(1., n(1, 0));
  n.col(last) << 0, std::copysign(1., n(1, last));
  return n;
}

double area(const Nodes& X) {
  double sum = 0;
  for_each_point(X, diagnostic_points(), [&](int, auto&, const CurvePoint& p) { sum += p.dS; });
  return sum;
}

double volume(const Nodes& X) {
  double sum = 0;  // the integrand is a polynomial of degree 8: exact
  for_each_point(X, diagnostic_points(), [&](int, const ShapeValues& s, const CurvePoint& p) {
    sum -= pi * p.x[0] * p.x[0] * p.dx[1] * s.weight;
  });
  return sum;
}

Eigen::VectorXd element_lengths(const Nodes& X) {
  Eigen::VectorXd length = Eigen::VectorXd::Zero(element_count(X));
  for_each_point(X, assembly_points(), [&](int e, const ShapeValues& s, const CurvePoint& p) {
    length[e] += p.stretch * s.weight;
  });
  return length;
}

}  // namespace sbeh::axisym
