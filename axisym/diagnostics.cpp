#include "axisym/diagnostics.h"

#include "axisym/curvature.h"
#include "model/energy_density.h"

#include <algorithm>
#include <cmath>

namespace sbeh::axisym {

Energy energy(const model::Material& material, const State& state, const Field& H) {
  Energy sum;
  for_each_point(state.X, diagnostic_points(),
                 [&](int e, const ShapeValues& s, const CurvePoint& p) {
    const double h = value_at(H, e, s);
    const double beta_s = slope_at(state.beta, e, s) / p.stretch;
    const auto density = model::energy_density(material, value_at(state.beta, e, s),
                                               beta_s * beta_s, h, gauss_curvature(h, p.B_phi));
    sum.distortion += p.dS * density.distortion;
    sum.bending += p.dS * (density.bending + density.gaussian);
    sum.thermotropic += p.dS * density.thermotropic;
  });
  return sum;
}

Diagnostics diagnose(const model::Material& material, const State& state) {
  const Field H = mean_curvature(state.X);
  Diagnostics d{};
  d.energy = energy(material, state, H);
  d.area = area(state.X);
  d.volume = volume(state.X);
  d.reduced_volume = reduced_volume(d.area, d.volume);

  double beta_1 = 0;
  for_each_point(state.X, diagnostic_points(),
                 [&](int e, const ShapeValues& s, const CurvePoint& p) {
    d.W2 += p.dS * value_at(H, e, s);
    beta_1 += p.dS * value_at(state.beta, e, s);
  });
  d.order_mean = beta_1 / d.area;
  for_each_point(state.X, diagnostic_points(),
                 [&](int e, const ShapeValues& s, const CurvePoint& p) {
    const double excess = value_at(state.beta, e, s) - d.order_mean;
    d.order_variance += p.dS * excess * excess / d.area;
  });
  d.order_std = std::sqrt(d.order_variance);

  d.order_min = d.order_max = state.beta[0];
  d.H_abs_max = d.radius_equator = 0;
  const Eigen::VectorXd length = element_lengths(state.X);
  for (int e = 0; e < element_count(state.X); ++e)
    for (int k = 0; k <= 12; ++k) {
      static const auto samples = [] {
        std::array<ShapeValues, 13> at{};
        for (int i = 0; i <= 12; ++i) at[std::size_t(i)] = shape_values(i / 12.);
        return at;
      }();
      const ShapeValues& s = samples[std::size_t(k)];
      const double beta = value_at(state.beta, e, s), h = value_at(H, e, s);
      double r = 0;
      for (int a = 0; a < 4; ++a) r += s.phi[a] * state.X(0, 3 * e + a);
      d.order_min = std::min(d.order_min, beta);
      d.order_max = std::max(d.order_max, beta);
      d.H_abs_max = std::max(d.H_abs_max, std::abs(h));
      d.rim_resolution = std::max(d.rim_resolution, std::abs(h) * length[e] / 3);
      if (r > d.radius_equator) {
        d.radius_equator = r;
        d.H_rim = h;
      }
    }
  d.H_pole = H[0];
  d.thickness_pole = state.X(1, 0) - state.X(1, state.X.cols() - 1);
  d.mesh_quality = length.minCoeff() / length.maxCoeff();
  return d;
}

}  // namespace sbeh::axisym
