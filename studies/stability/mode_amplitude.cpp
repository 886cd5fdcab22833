#include "studies/stability/mode_amplitude.h"

#include "meshing/spherical_harmonics.h"
#include "surface3d/moments.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

namespace sbeh::studies {

using Eigen::Vector3d;
using surface3d::SurfacePoint;

namespace {

constexpr double equal_moments = 0.05;

using History = std::span<const AmplitudeAt>;

History between(History history, double from, double to) {
  return {std::ranges::lower_bound(history, from, {}, &AmplitudeAt::time),
          std::ranges::upper_bound(history, to, {}, &AmplitudeAt::time)};
}

// Slope of ln amplitude; each point stands for the time to its neighbours, so that many small steps do not
// outweigh few large ones.
double slope(History history) {
  const auto weight = [&](std::size_t i) {
    const std::size_t before = i == 0 ? 0 : i - 1, after = std::min(i + 1, history.size() - 1);
    return history[after].time - history[before].time;
  };
  double total = 0, time = 0, value = 0;
  for (std::size_t i = 0; i < history.size(); ++i) {
    total += weight(i);
    time += weight(i) * history[i].time;
    value += weight(i) * std::log(history[i].amplitude);
  }
  time /= total;
  value /= total;
  double covariance = 0, variance = 0;
  for (std::size_t i = 0; i < history.size(); ++i) {
    const double t = history[i].time - time;
    covariance += weight(i) * t * (std::log(history[i].amplitude) - value);
    variance += weight(i) * t * t;
  }
  return covariance / variance;
}

// Of the window [from, to]; empty where there are too few amplitudes.
std::optional<GrowthRate> fit(History history, double from, double to) {
  std::array<double, 3> thirds{};
  for (std::size_t k = 0; k < 3; ++k) {
    const double third = (to - from) / 3;
    const History part = between(history, from + double(k) * third, from + double(k + 1) * third);
    if (part.size() < fewest_amplitudes) return {};
    thirds[k] = slope(part);
  }
  const auto [least, largest] = std::minmax_element(thirds.begin(), thirds.end());
  return GrowthRate{.rate = slope(between(history, from, to)),
                    .error = (*largest - *least) / 2,
                    .from = from,
                    .to = to};
}

}  // namespace

double mode_amplitude(const surface3d::Triangulation& mesh, const surface3d::Nodes& X, int l,
                      int m) {
  const Vector3d centre = moments_of(samples_of(mesh, X)).centre;
  double cosine = 0, sine = 0, total = 0;
  surface3d::for_each_point(mesh, X, surface3d::assembly_points(),
                            [&](int, const surface3d::ShapeValues&, const SurfacePoint& p) {
                              const double r = (p.x - centre).norm();
                              if (r == 0) return;
                              const Vector3d direction = (p.x - centre) / r;
                              const double weight = p.dS * std::pow(r, l);
                              cosine += weight * meshing::spherical_harmonic(l, m, direction);
                              sine += weight * meshing::spherical_harmonic(l, -m, direction);
                              total += weight;
                            });
  return std::hypot(cosine, sine) / total;
}

Roundness roundness_of(const surface3d::Triangulation& mesh, const surface3d::Nodes& X) {
  const Vector3d w = moments_of(samples_of(mesh, X)).principal;
  const double range = w[2] - w[0];
  if (w[1] - w[0] < equal_moments * range) return Roundness::prolate;
  if (w[2] - w[1] < equal_moments * range) return Roundness::oblate;
  return Roundness::triaxial;
}

std::optional<GrowthRate> fit_growth(const std::vector<AmplitudeAt>& history,
                                     std::optional<double> settled) {
  if (history.empty() || !(history.front().amplitude > 0)) return {};
  const double start = history.front().amplitude;
  const auto beyond = std::find_if(history.begin(), history.end(), [&](const AmplitudeAt& at) {
    return at.amplitude > most_growth * start || !(at.amplitude > most_decay * start);
  });
  const History linear(history.begin(), beyond);
  const double begin = linear.front().time, end = linear.back().time;
  if (settled && *settled < end)
    if (const auto known = fit(linear, std::max(begin, *settled), end)) return known;
  std::optional<GrowthRate> best;
  for (const double share : {0., 1. / 16, 1. / 8, 1. / 4, 1. / 2}) {
    const auto rate = fit(linear, begin + share * (end - begin), end);
    if (rate && (!best || rate->error < best->error)) best = rate;
  }
  return best;
}

}  // namespace sbeh::studies
