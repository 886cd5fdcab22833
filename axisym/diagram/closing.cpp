#include "axisym/diagram/closing.h"

#include "model/numerics/root.h"

#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>

namespace sbeh::axisym {

using std::numbers::pi;

namespace {

// So many spheres of either radius, R and r; those of r are turned inside out where nested.
struct Kinds {
  int of_R, of_r;
  bool nested;

  double r(double R) const { return std::sqrt((1 - of_R * R * R) / of_r); }
  double side() const { return nested ? -1 : 1; }
  TouchingSpheres spheres(double R) const {
    TouchingSpheres all{{}, nested};
    for (int k = 0; k < of_R; ++k) all.radii.push_back(R);
    for (int k = 0; k < of_r; ++k) all.radii.push_back(r(R));
    return all;
  }
};

// What vanishes where the necks are ideal.
double miss(const model::Material& material, const Kinds& kinds, double R) {
  const double r = kinds.r(R), area = 4 * pi, kappa = material.kappa(model::full_order);
  const double W2 = -8 * pi * (kinds.of_R * R + kinds.side() * kinds.of_r * r);
  const model::AreaDifference& ad = material.area_difference;
  const double mean_H = -(1 / R + kinds.side() / r);
  const double moment = kappa * (mean_H - material.preferred_curvature());
  if (!ad.is_there()) return moment;
  return moment * ad.compliance() + (W2 - ad.W2) / area;
}

}  // namespace

std::vector<TouchingSpheres> with_ideal_necks(const model::Material& material, int most) {
  constexpr int samples = 400;
  constexpr double margin = 1e-6;
  std::vector<TouchingSpheres> found;
  const auto add = [&](const Kinds& kinds, double low, double high) {
    const auto at = [&](double R) { return miss(material, kinds, R); };
    for (int k = 0; k < samples; ++k) {
      const double a = low + (high - low) * k / samples, b = low + (high - low) * (k + 1) / samples;
      if (at(a) * at(b) <= 0)
        found.push_back(kinds.spheres(model::root_between(at, a, b).middle()));
    }
  };
  const double equal = std::sqrt(0.5), one = 1 - margin;
  add({1, 1, true}, equal * (1 + margin), one);
  add({1, 2, true}, margin, one);
  add({1, 1, false}, equal * (1 + margin), one);  // R > r: the others are the same
  for (int count = 3; count <= most; ++count)
    for (const int of_R : {count / 2, count - count / 2}) {
      add({of_R, count - of_R, false}, margin, std::sqrt(1. / of_R) * one);
      if (count % 2 == 0) break;
    }
  return found;
}

std::optional<TouchingSpheres> closing_shape(const model::Material& material,
                                             const Diagnostics& state) {
  constexpr double near = 0.05;  // of V_r, and of W₂/8π: a neck of radius a is off by a ln(1/a)
  constexpr int most = 5;
  std::vector<TouchingSpheres> candidates = with_ideal_necks(material, most);
  for (int count = 2; count <= most; ++count) candidates.push_back(chain_of_spheres(count));
  std::optional<TouchingSpheres> best;
  double least = near;
  for (const TouchingSpheres& spheres : candidates) {
    const Diagnostics d = diagnose(material, spheres);
    const double distance = std::max(std::abs(d.reduced_volume - state.reduced_volume),
                                     std::abs(d.W2 - state.W2) / (8 * pi));
    if (distance < least) {
      least = distance;
      best = spheres;
    }
  }
  return best;
}

namespace {

// Of the states of these radii.
std::vector<double> extrapolated(const std::array<const ClosingMeasures*, 3>& at) {
  Eigen::Matrix3d rows;
  for (int k = 0; k < 3; ++k) {
    const double a = at[std::size_t(k)]->radius;
    rows.row(k) << 1, a, a * std::log(a);
  }
  const Eigen::Vector3d weights = rows.transpose().inverse().col(0);
  std::vector<double> values(at[0]->values.size(), 0.);
  for (int k = 0; k < 3; ++k)
    for (std::size_t i = 0; i < values.size(); ++i)
      values[i] += weights[k] * at[std::size_t(k)]->values[i];
  return values;
}

}  // namespace

ClosedMeasures with_closed_neck(const std::array<ClosingMeasures, 4>& way) {
  const auto fine = extrapolated({&way[0], &way[1], &way[2]}),
             coarse = extrapolated({&way[1], &way[2], &way[3]});
  ClosedMeasures closed{fine, {}};
  for (std::size_t i = 0; i < fine.size(); ++i)
    closed.errors.push_back(std::abs(fine[i] - coarse[i]));
  return closed;
}

}  // namespace sbeh::axisym
