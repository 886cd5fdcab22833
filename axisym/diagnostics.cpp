#include "axisym/diagnostics.h"

#include "axisym/circles.h"
#include "axisym/curvature.h"
#include "axisym/domains.h"
#include "axisym/shape_class.h"
#include "model/energy_density.h"

#include <Eigen/QR>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace sbeh::axisym {

Energy energy(const model::Material& material, const State& state, const Field& H) {
  // ∫K = 4π: where the order is uniform but for rounding, its κ_G K adds up to a constant without the error of K.
  const double beta = state.beta[0];
  const bool uniform = (state.beta.array() - beta).abs().maxCoeff() < 1e-9;
  const double constant = uniform ? material.kappa_gauss(beta) : 0;
  Energy sum{.bending = 4 * std::numbers::pi * constant};
  double area = 0, W2 = 0;
  for_each_point(
      state.X, diagnostic_points(), [&](int e, const ShapeValues& s, const CurvePoint& p) {
        const double h = value_at(H, e, s), K = gauss_curvature(h, p.B_phi);
        const double beta_s = slope_at(state.beta, e, s) / p.stretch;
        const auto density =
            model::energy_density(material, value_at(state.beta, e, s), beta_s * beta_s, h, K);
        sum.distortion += p.dS * density.distortion;
        sum.bending += p.dS * (density.bending + density.gaussian - constant * K);
        sum.thermotropic += p.dS * density.thermotropic;
        area += p.dS;
        W2 += p.dS * h;
      });
  sum.area_difference = material.area_difference.energy(area, W2);
  return sum;
}

namespace {

// At the pole where the nodes begin (step = 1) or end (step = −1).
double pole_curvature(const Field& H, const Eigen::VectorXd& length, int step) {
  const Eigen::Index last = H.size() - 1, pole = step > 0 ? 0 : last;
  const auto element = [&](int e) { return length[step > 0 ? e : length.size() - 1 - e]; };
  Eigen::Matrix<double, 10, 3> powers;
  Eigen::Matrix<double, 10, 1> values;
  double s = element(0);
  const double unit = element(0) + element(1) + element(2) + element(3);
  for (int k = 0; k < 10; ++k) {
    const double x = s / unit;
    powers.row(k) << 1, x * x, x * x * x * x;
    values[k] = H[pole + step * (3 + k)];
    s += element(1 + std::min(k, 8) / 3) / 3;
  }
  return powers.colPivHouseholderQr().solve(values)[0];
}

}  // namespace

std::array<double, 2> pole_curvatures(const Nodes& X, const Field& H) {
  const Eigen::VectorXd length = element_lengths(X);
  return {pole_curvature(H, length, 1), pole_curvature(H, length, -1)};
}

Diagnostics diagnose(const model::Material& material, const State& state) {
  const Field H = mean_curvature(state.X);
  Diagnostics d{};
  d.energy = energy(material, state, H);
  d.area = area(state.X);
  d.volume = volume(state.X);
  d.reduced_volume = reduced_volume(d.area, d.volume);
  d.W2 = total_mean_curvature(state.X, H);

  double beta_1 = 0;
  for_each_point(state.X, diagnostic_points(),
                 [&](int e, const ShapeValues& s, const CurvePoint& p) {
                   beta_1 += p.dS * value_at(state.beta, e, s);
                 });
  d.order_mean = beta_1 / d.area;
  for_each_point(state.X, diagnostic_points(),
                 [&](int e, const ShapeValues& s, const CurvePoint& p) {
                   const double excess = value_at(state.beta, e, s) - d.order_mean;
                   d.order_variance += p.dS * excess * excess / d.area;
                 });
  d.order_std = std::sqrt(d.order_variance);
  d.domains = domains_of(state);

  d.order_min = d.order_max = state.beta[0];
  const Eigen::VectorXd length = element_lengths(state.X);
  const int elements = element_count(state.X);
  const auto [north, south] = pole_curvatures(state.X, H);
  d.H_pole = north;
  d.H_abs_max = std::max(std::abs(north), std::abs(south));
  for (int e = 0; e < elements; ++e)
    for (const ShapeValues& s : even_points<12>()) {
      const double beta = value_at(state.beta, e, s), h = value_at(H, e, s);
      d.order_min = std::min(d.order_min, beta);
      d.order_max = std::max(d.order_max, beta);
      if (e > 0 && e < elements - 1) d.H_abs_max = std::max(d.H_abs_max, std::abs(h));
    }
  const Circle widest = widest_circle(state.X, H);
  const ShapeClass shape = classify(state.X);
  const bool is_symmetric = shape == ShapeClass::oblate || shape == ShapeClass::prolate;
  d.radius_equator = is_symmetric ? middle_circle(state.X, H).radius : widest.radius;
  d.H_rim = widest.H;
  d.resolution = resolution(state.X, H);
  d.thickness_pole = state.X(1, 0) - state.X(1, state.X.cols() - 1);
  d.mesh_quality = length.minCoeff() / length.maxCoeff();
  return d;
}

}  // namespace sbeh::axisym
