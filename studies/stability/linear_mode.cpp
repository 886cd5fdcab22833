#include "studies/stability/linear_mode.h"

#include "axisym/modes/eigenmodes.h"
#include "axisym/modes/growth_rates.h"
#include "studies/modes/mode_file.h"
#include "studies/scan/branch_points.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace sbeh::studies {

double LinearMode::settled_at() const {
  return next_rate && *next_rate < rate ? std::log(100) / (rate - *next_rate) : 0;
}

double LinearMode::gone_at() const {
  return is_resolved && rate < 0 ? std::log(50) / -rate : std::numeric_limits<double>::infinity();
}

std::optional<LinearMode> linear_mode(const axisym::StationaryCase& of, const axisym::State& state,
                                      int l, int m) {
  constexpr int count = 2;
  const auto at_rest = settled(of, state);
  if (!at_rest) return {};
  const axisym::SecondVariation second = axisym::second_variation(of.material, of.model, *at_rest);
  const auto spectrum = axisym::lowest_modes(second, m, count);
  const auto rates = axisym::growth_rates({second, of.material, of.model}, m, count);
  if (!spectrum || !rates) return {};
  const auto is_ours = [&](axisym::Parity parity) { return is_of_harmonic(l, m, parity); };
  const auto lowest = std::ranges::find_if(spectrum->modes, is_ours, &axisym::Eigenmode::parity);
  const auto fastest = std::ranges::find_if(*rates, is_ours, &axisym::GrowthMode::parity);
  if (lowest == spectrum->modes.end() || fastest == rates->end()) return {};
  LinearMode mode{lowest->eigenvalue, fastest->rate, {},        false,
                  fastest->parity,    fastest->u,    fastest->b};
  normalise(mode.u, mode.b);
  const auto next = std::find_if(fastest + 1, rates->end(), [&](const axisym::GrowthMode& one) {
    return is_ours(one.parity);
  });
  if (next != rates->end()) mode.next_rate = next->rate;
  mode.is_resolved =
      std::abs(mode.eigenvalue) > spectrum->rigid_residual && mode.eigenvalue * mode.rate < 0;
  return mode;
}

}  // namespace sbeh::studies
