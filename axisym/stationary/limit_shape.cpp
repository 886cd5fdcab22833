#include "axisym/stationary/limit_shape.h"

#include "model/energy_density.h"
#include "model/numerics/root.h"

#include <cmath>
#include <limits>
#include <numbers>

namespace sbeh::axisym {

std::optional<TwoSpheres> two_spheres(double reduced_volume, bool nested) {
  const auto volume = [nested](double outer) {
    const double inner = std::pow(1 - outer * outer, 1.5);
    return outer * outer * outer + (nested ? -inner : inner);
  };
  const double equal = std::sqrt(0.5);
  if (!(reduced_volume >= volume(equal) && reduced_volume < 1)) return {};
  const double outer =
      model::root_between([&](double r) { return volume(r) - reduced_volume; }, equal, 1).middle();
  return TwoSpheres{outer, std::sqrt(1 - outer * outer), nested};
}

double closing_H0(const TwoSpheres& spheres) {
  return -1 / spheres.outer + (spheres.nested ? 1 : -1) / spheres.inner;
}

Diagnostics diagnose(const model::Material& material, const TwoSpheres& spheres) {
  constexpr double unknown = std::numeric_limits<double>::quiet_NaN(), pi = std::numbers::pi;
  Diagnostics d{};
  const double beta = model::full_order;
  for (const auto& [R, sign] :
       {std::pair{spheres.outer, -1.}, {spheres.inner, spheres.nested ? 1. : -1.}}) {
    const double dS = 4 * pi * R * R, H = 2 * sign / R;
    const auto density = model::energy_density(material, beta, 0., H, 1 / (R * R));
    d.energy.bending += dS * (density.bending + density.gaussian);
    d.energy.thermotropic += dS * density.thermotropic;
    d.area += dS;
    d.volume += -sign * 4 * pi / 3 * R * R * R;
    d.W2 += dS * H;
  }
  d.energy.bending -= 4 * pi * material.kappa_gauss(beta);  // ∫K = −4π over the vanishing neck
  d.reduced_volume = reduced_volume(d.area, d.volume);
  d.order_min = d.order_mean = d.order_max = beta;
  d.radius_equator = spheres.outer;
  d.H_pole = d.H_rim = d.H_abs_max = d.thickness_pole = d.resolution = d.mesh_quality = unknown;
  return d;
}

}  // namespace sbeh::axisym
