#include "model/rest_order.h"

#include "model/terms.h"

#include <boost/math/tools/roots.hpp>

#include <cstdint>

namespace sbeh::model {

std::optional<double> sphere_rest_order(const Material& material) {
  const auto force = [&](double beta) { return order_force(material, beta, -2., 1.); };
  constexpr int samples = 4096;
  for (int k = samples; k > 1; --k) {
    const double high = double(k) / samples, low = double(k - 1) / samples;
    if (!(force(high) >= 0 && force(low) < 0)) continue;
    std::uintmax_t iterations = 100;
    const auto bracket = boost::math::tools::toms748_solve(
        force, low, high, boost::math::tools::eps_tolerance<double>(52), iterations);
    return (bracket.first + bracket.second) / 2;
  }
  return {};
}

}  // namespace sbeh::model
