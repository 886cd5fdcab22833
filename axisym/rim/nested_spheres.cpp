#include "axisym/rim/nested_spheres.h"

#include "model/energy_density.h"
#include "model/numerics/root.h"
#include "model/terms.h"

#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <string>

namespace sbeh::axisym {

using std::numbers::pi;

NestedRadii nested_radii(double reduced_volume) {
  if (!(reduced_volume > 0 && reduced_volume < 1))
    throw std::invalid_argument("nested_radii: reduced volume " + std::to_string(reduced_volume)
                                + ": must lie between 0 and 1");
  const auto miss = [&](double angle) {
    return std::pow(std::cos(angle), 3) - std::pow(std::sin(angle), 3) - reduced_volume;
  };
  const double angle = model::root_between(miss, 0, pi / 4).middle();
  return {std::cos(angle), std::sin(angle)};
}

OrderedSphere ordered_sphere(const model::Material& material, double R, bool inside) {
  const double H = (inside ? 2 : -2) / R, K = 1 / (R * R);
  const auto energy = [&](double beta) {
    return model::energy_density(material, beta, 0., H, K).total();
  };
  const auto force = [&](double beta) { return model::order_force(material, beta, H, K); };
  constexpr int samples = 1000;
  int best = 0;
  for (int k = 1; k <= samples; ++k)
    if (energy(double(k) / samples) < energy(double(best) / samples)) best = k;
  double order = double(best) / samples;
  const double low = (best - 1.) / samples, high = (best + 1.) / samples;
  if (best > 0 && best < samples && force(low) < 0 && force(high) > 0)
    order = model::root_between(force, low, high).middle();
  return {order, energy(order)};
}

namespace {

double energy_of_both(const model::Material& material, double reduced_volume) {
  const auto [outer, inner] = nested_radii(reduced_volume);
  return 4 * pi
       * (outer * outer * ordered_sphere(material, outer, false).energy
          + inner * inner * ordered_sphere(material, inner, true).energy);
}

// From the pole of the inner sphere to the neck, and on to that of the outer one.
State profile_of(const model::Material& material, const NestedRadii& radii) {
  constexpr int half = 72;  // intervals: 24 elements
  State state{.X = Nodes::Zero(2, 2 * half + 1), .beta = Field(2 * half + 1)};
  for (int k = 0; k <= half; ++k) {
    const double angle = pi * k / half;
    state.X.col(k) << radii.inner * std::sin(angle), -radii.inner * (1 + std::cos(angle));
    state.X.col(half + k) << radii.outer * std::sin(angle), -radii.outer * (1 - std::cos(angle));
  }
  state.X(0, 0) = state.X(0, half) = state.X(0, 2 * half) = 0;
  state.beta.head(half).setConstant(ordered_sphere(material, radii.inner, true).order);
  state.beta.tail(half).setConstant(ordered_sphere(material, radii.outer, false).order);
  state.beta[half] = 0;
  return state;
}

}  // namespace

RimRecord nested_spheres(const model::Material& material, double reduced_volume, double L) {
  const model::Material at = material.with_L1(L);
  constexpr double infinity = std::numeric_limits<double>::infinity();
  constexpr double undefined = std::numeric_limits<double>::quiet_NaN();
  const double dv = 1e-4 * std::min(reduced_volume, 1 - reduced_volume);
  return {.kind = RimKind::nested_spheres,
          .reduced_volume = reduced_volume,
          .L = L,
          .energy = energy_of_both(at, reduced_volume),
          .order_rim = 0,
          .H_rim = undefined,
          .H_abs_max = infinity,
          .jump = pi,
          .resolution = 0,
          .pressure =
              (energy_of_both(at, reduced_volume + dv) - energy_of_both(at, reduced_volume - dv))
              / (8 * pi / 3 * dv),
          .negative_directions = {},
          .state = profile_of(at, nested_radii(reduced_volume))};
}

}  // namespace sbeh::axisym
