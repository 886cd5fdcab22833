#include "axisym/curvature.h"

#include "model/numerics/band_matrix.h"

#include <Eigen/LU>

#include <cmath>
#include <numbers>

namespace sbeh::axisym {

Field mean_curvature(const Nodes& X) {
  const Nodes n = node_normals(X);
  model::BandMatrix mass(int(X.cols()), 3);
  Field rhs = Field::Zero(X.cols());
  for_each_point(X, assembly_points(), [&](int e, const ShapeValues& s, const CurvePoint& p) {
    for (int a = 0; a < 4; ++a) {
      const int i = 3 * e + a;
      const double cosine = p.dS * p.nu.dot(n.col(i));
      rhs[i] -= p.dS * (s.dphi[a] * p.t.dot(n.col(i)) / p.stretch + s.phi[a] * n(0, i) / p.x[0]);
      for (int b = 0; b < 4; ++b) mass(i, 3 * e + b) += cosine * s.phi[a] * s.phi[b];
    }
  });
  if (!mass.factor()) return {};
  mass.solve(rhs);
  return rhs;
}

bool correct_area_volume(Nodes& X, double area_asked, double volume_asked) {
  const Field H = mean_curvature(X);
  if (H.size() == 0) return false;
  const Nodes n = node_normals(X);
  const Nodes shift = n * H.asDiagonal();
  const auto moved = [&](const Eigen::Vector2d& c) -> Nodes { return X + c[0] * n + c[1] * shift; };
  const auto miss = [&](const Nodes& Y) {
    return Eigen::Vector2d(area(Y) / area_asked - 1, volume(Y) / volume_asked - 1);
  };
  const bool sphere = is_sphere(axisym::area(X), axisym::volume(X));
  Eigen::Vector2d c = Eigen::Vector2d::Zero();
  for (int iteration = 0; iteration < 12; ++iteration) {
    Eigen::Vector2d residual = miss(moved(c));
    if (sphere) residual[1] = 0;
    if (!residual.allFinite()) return false;
    if (residual.cwiseAbs().maxCoeff() < 1e-12) {
      X = moved(c);
      return true;
    }
    // Central differences: A and V are smooth and of low degree in a and b.
    const double h = 1e-4;
    Eigen::Matrix2d J;
    for (int k = 0; k < 2; ++k)
      J.col(k) = (miss(moved(c + h * Eigen::Vector2d::Unit(k)))
                  - miss(moved(c - h * Eigen::Vector2d::Unit(k))))
               / (2 * h);
    if (sphere) J.row(1) << 0, 1;  // b = 0
    c -= J.fullPivLu().solve(residual);
  }
  return false;
}

}  // namespace sbeh::axisym
