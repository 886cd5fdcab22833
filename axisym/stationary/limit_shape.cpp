#include "axisym/stationary/limit_shape.h"

#include "model/energy_density.h"
#include "model/numerics/root.h"

#include <cmath>
#include <limits>
#include <numbers>

namespace sbeh::axisym {

using std::numbers::pi;

namespace {

// Of the k-th sphere: 1 where its outside is the membrane's, −1 where it is turned inside out.
double side(const TouchingSpheres& spheres, std::size_t k) {
  return spheres.nested && k > 0 ? -1 : 1;
}

double H_of(const TouchingSpheres& spheres, std::size_t k) {
  return -2 * side(spheres, k) / spheres.radii[k];
}

}  // namespace

TouchingSpheres sphere_in_sphere(double reduced_volume) {
  const auto miss = [&](double outer) {
    return outer * outer * outer - std::pow(1 - outer * outer, 1.5) - reduced_volume;
  };
  const double outer = model::root_between(miss, std::sqrt(0.5), 1).middle();
  return {{outer, std::sqrt(1 - outer * outer)}, true};
}

std::optional<TouchingSpheres> sphere_beside_sphere(double reduced_volume) {
  const auto miss = [&](double larger) {
    return larger * larger * larger + std::pow(1 - larger * larger, 1.5) - reduced_volume;
  };
  const double equal = std::sqrt(0.5);
  if (miss(equal) > 0 || miss(1) < 0) return {};
  const double larger = model::root_between(miss, equal, 1).middle();
  return TouchingSpheres{{larger, std::sqrt(1 - larger * larger)}, false};
}

TouchingSpheres chain_of_spheres(int count) {
  return {std::vector<double>(std::size_t(count), 1 / std::sqrt(count)), false};
}

double closing_H0(const TouchingSpheres& spheres) {
  return (H_of(spheres, 0) + H_of(spheres, 1)) / 2;
}

Diagnostics diagnose(const model::Material& material, const TouchingSpheres& spheres) {
  constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
  const double beta = model::full_order, necks = double(spheres.radii.size()) - 1;
  Diagnostics d{};
  for (std::size_t k = 0; k < spheres.radii.size(); ++k) {
    const double R = spheres.radii[k], dS = 4 * pi * R * R, H = H_of(spheres, k);
    const auto density = model::energy_density(material, beta, 0., H, 1 / (R * R));
    d.energy.bending += dS * (density.bending + density.gaussian);
    d.energy.thermotropic += dS * density.thermotropic;
    d.area += dS;
    d.volume += side(spheres, k) * 4 * pi / 3 * R * R * R;
    d.W2 += dS * H;
  }
  d.energy.bending -=
      necks * 4 * pi * material.kappa_gauss(beta);  // ∫K = −4π over a vanishing neck
  d.energy.area_difference = material.area_difference.energy(d.area, d.W2);
  d.reduced_volume = reduced_volume(d.area, d.volume);
  d.order_min = d.order_mean = d.order_max = beta;
  d.radius_equator = spheres.radii[0];
  d.H_pole = d.H_rim = d.H_abs_max = d.thickness_pole = d.resolution = d.mesh_quality = unknown;
  return d;
}

}  // namespace sbeh::axisym
