#include "model/rest_order.h"

#include "model/numerics/root.h"
#include "model/terms.h"

namespace sbeh::model {

std::optional<double> sphere_rest_order(const Material& material) {
  const auto force = [&](double beta) { return order_force(material, beta, -2., 1.); };
  constexpr int samples = 4096;
  for (int k = samples; k > 1; --k) {
    const double high = double(k) / samples, low = double(k - 1) / samples;
    if (force(high) >= 0 && force(low) < 0) return root_between(force, low, high).middle();
  }
  return {};
}

}  // namespace sbeh::model
