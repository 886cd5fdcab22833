#include "axisym/modes/stability_3d.h"

#include "axisym/modes/growth_rates.h"

#include <algorithm>
#include <cmath>

namespace sbeh::axisym {

namespace {
constexpr int last_m = 64;  // that is looked at where all before it have negative eigenvalues
}

std::optional<Stability3d> stability_3d(const model::Material& material, model::Model model,
                                        const StationaryState& state, int largest_m) {
  const SecondVariation second = second_variation(material, model, state);
  const LinearFlow flow(second, material, model);
  Stability3d result;
  result.rigid_residual = 0;
  int negative = 0;
  double nearest_to_zero = std::numeric_limits<double>::infinity();
  bool ends = false;  // whether higher m have none
  for (int m = 0; m <= largest_m || (!ends && m <= last_m); ++m) {
    const auto found = lowest_and_negative_modes(second, m, 1);
    if (!found) return {};
    result.rigid_residual = std::max(result.rigid_residual, found->rigid_residual);
    if (m <= largest_m) {
      result.eigenvalue[std::size_t(m)] = found->modes.front().eigenvalue;
      if (const auto rates = growth_rates(flow, m, 1))
        result.rate[std::size_t(m)] = rates->front().rate;
    }
    int falling = 0;
    for (const Eigenmode& mode : found->modes) {
      nearest_to_zero = std::min(nearest_to_zero, std::abs(mode.eigenvalue));
      falling += mode.eigenvalue < 0;
    }
    negative += m == 0 ? falling : 2 * falling;
    if (falling > 0) result.unstable.push_back(m);
    ends = falling == 0;
  }
  if (ends && nearest_to_zero > result.rigid_residual) result.negative_directions = negative;
  return result;
}

}  // namespace sbeh::axisym
