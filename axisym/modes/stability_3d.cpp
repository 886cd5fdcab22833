#include "axisym/modes/stability_3d.h"

#include "axisym/modes/growth_rates.h"

#include <algorithm>
#include <cmath>

namespace sbeh::axisym {

std::optional<ModeSpectrum> lowest_and_negative_modes(const SecondVariation& second, int m,
                                                      int count) {
  for (const int most = 64 * count; count <= most; count *= 2) {
    auto found = lowest_modes(second, m, count);
    if (!found || found->modes.empty()) return {};
    // Each parity has `count` modes: all are there when the highest of each is not negative.
    const auto is_complete = [&](Parity parity) {
      const auto last =
          std::ranges::find(found->modes.rbegin(), found->modes.rend(), parity, &Eigenmode::parity);
      return last == found->modes.rend() || last->eigenvalue >= 0;
    };
    if (is_complete(Parity::even) && is_complete(Parity::odd) && is_complete(Parity::none))
      return found;
  }
  return {};
}

std::optional<Stability3d> stability_3d(const model::Material& material, model::Model model,
                                        const StationaryState& state, int largest_m) {
  const SecondVariation second = second_variation(material, model, state);
  Stability3d result;
  result.rigid_residual = 0;
  int negative = 0;
  double nearest_to_zero = std::numeric_limits<double>::infinity();
  for (int m = 0; m <= largest_m; ++m) {
    const auto found = lowest_and_negative_modes(second, m, 1);
    if (!found) return {};
    result.eigenvalue[std::size_t(m)] = found->modes.front().eigenvalue;
    result.rigid_residual = std::max(result.rigid_residual, found->rigid_residual);
    if (const auto rates = growth_rates(second, material, model, m, 1))
      result.rate[std::size_t(m)] = rates->front().rate;
    int falling = 0;
    for (const Eigenmode& mode : found->modes) {
      nearest_to_zero = std::min(nearest_to_zero, std::abs(mode.eigenvalue));
      falling += mode.eigenvalue < 0;
    }
    negative += m == 0 ? falling : 2 * falling;
    if (falling > 0) result.unstable.push_back(m);
  }
  if (nearest_to_zero > result.rigid_residual) result.negative_directions = negative;
  return result;
}

}  // namespace sbeh::axisym
