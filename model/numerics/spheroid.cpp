#include "model/numerics/spheroid.h"

#include "model/numerics/area_volume.h"
#include "model/numerics/root.h"

#include <cmath>
#include <numbers>

namespace sbeh::model {

using std::numbers::pi;

double spheroid_area(double q) {
  const double e = std::sqrt(std::abs(1 - q * q));
  if (!(e > 1e-6)) return 4 * pi;
  return 2 * pi * (1 + q * q / e * (q < 1 ? std::atanh(e) : std::atan(e)));
}

double spheroid_reduced_volume(double q) {
  return reduced_volume(spheroid_area(q), 4 * pi / 3 * q);
}

double spheroid_axis_ratio(double reduced_volume, bool prolate) {
  if (!(reduced_volume < 1 - 1e-12)) return 1;
  const auto miss = [=](double log_q) {
    return spheroid_reduced_volume(std::exp(log_q)) - reduced_volume;
  };
  return std::exp(root_between(miss, prolate ? 0 : -30, prolate ? 30 : 0, 50).low);
}

}  // namespace sbeh::model
