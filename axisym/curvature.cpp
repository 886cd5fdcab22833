#include "axisym/curvature.h"

#include "model/numerics/area_volume.h"
#include "model/numerics/band_matrix.h"

namespace sbeh::axisym {

Field mean_curvature(const Nodes& X) {
  const Nodes n = node_normals(X);
  model::BandMatrix mass(int(X.cols()), 3);
  Field rhs = Field::Zero(X.cols());
  for_each_point(X, assembly_points(), [&](int e, const ShapeValues& s, const CurvePoint& p) {
    for (int a = 0; a < 4; ++a) {
      const int i = 3 * e + a;
      const double cosine = p.dS * p.nu.dot(n.col(i));
      rhs[i] -=
          p.dS * (s.dphi[a] * p.t.dot(n.col(i)) / p.stretch + s.phi[a] * n(0, i) / p.x[0]);  // (H1)
      for (int b = 0; b < 4; ++b) mass(i, 3 * e + b) += cosine * s.phi[a] * s.phi[b];        // (H1)
    }
  });
  if (!mass.factor()) return {};
  mass.solve(rhs);
  return rhs;
}

double total_mean_curvature(const Nodes& X, const Field& H) {
  double total = 0;
  for_each_point(X, diagnostic_points(), [&](int e, const ShapeValues& s, const CurvePoint& p) {
    total += p.dS * value_at(H, e, s);
  });
  return total;
}

double resolution(const Nodes& X, const Field& H) {
  constexpr int samples = 12;  // of an element
  const Eigen::VectorXd length = element_lengths(X);
  double largest = 0;
  for (int e = 0; e < element_count(X); ++e)
    for (const ShapeValues& s : even_points<samples>()) {
      const CurvePoint point = curve_point(X, e, s);
      if (point.x[0] > 1e-9)  // off the axis, where B_φφ is defined
        largest = std::max(largest, std::abs(value_at(H, e, s) - point.B_phi) * length[e] / 3);
    }
  return largest;
}

bool correct_area_volume(Nodes& X, double area_asked, double volume_asked) {
  const Field H = mean_curvature(X);
  if (H.size() == 0) return false;
  const Nodes n = node_normals(X);
  const Nodes shift = n * H.asDiagonal();
  const auto moved = [&](const Eigen::Vector2d& c) -> Nodes { return X + c[0] * n + c[1] * shift; };
  const auto miss = [&](const Eigen::Vector2d& c) -> Eigen::Vector2d {
    const Nodes Y = moved(c);
    return {area(Y) / area_asked - 1, volume(Y) / volume_asked - 1};
  };
  const auto c = model::solve_area_volume(miss, is_sphere(axisym::area(X), axisym::volume(X)));
  if (c) X = moved(*c);
  return c.has_value();
}

}  // namespace sbeh::axisym
