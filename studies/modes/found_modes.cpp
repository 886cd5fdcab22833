#include "studies/modes/found_modes.h"

#include "axisym/modes/growth_rates.h"
#include "axisym/stationary/accuracy.h"
#include "studies/io/interrupt.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <stdexcept>

namespace sbeh::studies {

namespace {

// Those of one m by their numbers: the lowest `most` of each parity, and all that are negative.
std::vector<FoundMode> numbered(const axisym::ModeSpectrum& spectrum, const Physics& physics,
                                const axisym::State& state, int most) {
  std::map<axisym::Parity, int> count;
  std::vector<FoundMode> modes;
  for (const axisym::Eigenmode& of : spectrum.modes) {
    if (count[of.parity] >= most && of.eigenvalue >= 0) continue;
    const ModeKey key{of.m, of.parity, ++count[of.parity]};
    modes.push_back({{physics, state, key, of.eigenvalue, not_known, of.u, of.b}, of.u, of.b});
  }
  std::ranges::stable_sort(modes, {}, [](const StateMode& mode) { return mode.key.parity; });
  return modes;
}

FoundMode* find(std::vector<FoundMode>& modes, axisym::Parity parity, int number) {
  const auto at = std::ranges::find_if(modes, [&](const StateMode& mode) {
    return mode.key.parity == parity && mode.key.number == number;
  });
  return at == modes.end() ? nullptr : &*at;
}

// The largest rates of m, `count` of each parity or at least half of that; none where they are not found.
std::vector<axisym::GrowthMode> rates_of(const axisym::LinearFlow& flow, int m, int count) {
  for (; count > 0; count /= 2)
    if (auto rates = axisym::growth_rates(flow, m, count)) return *rates;
  return {};
}

// The modes of the flow take the place of those of the same number: there are as many that grow as there are
// negative eigenvalues. Those that are not found leave the energy's, without a rate.
void take_rates(const axisym::LinearFlow& flow, std::vector<FoundMode>& modes) {
  int count = 0;
  for (const StateMode& mode : modes) count = std::max(count, mode.key.number);
  std::map<axisym::Parity, int> taken;
  for (const axisym::GrowthMode& growth : rates_of(flow, modes.front().key.m, count)) {
    FoundMode* mode = find(modes, growth.parity, ++taken[growth.parity]);
    if (!mode) continue;
    mode->rate = growth.rate;
    mode->u = growth.u;
    if (has_free_order(mode->model)) mode->b = growth.b;  // otherwise it is 0 but for rounding
  }
}

struct ModesOfM {
  std::vector<FoundMode> modes;
  double rigid_residual;
};
std::optional<ModesOfM> modes_of(const ModesInput& input, const Physics& physics,
                                 const axisym::LinearFlow& flow, int m) {
  if (interrupt_signal() != 0) throw Interrupted("interrupted");
  const auto spectrum = axisym::lowest_and_negative_modes(flow.second, m, input.number);
  if (!spectrum) return {};
  ModesOfM found{numbered(*spectrum, physics, flow.second.state, input.number),
                 spectrum->rigid_residual};
  take_rates(flow, found.modes);
  return found;
}

void take_errors(std::vector<FoundMode>& modes, std::vector<FoundMode> coarse) {
  for (FoundMode& mode : modes)
    if (const FoundMode* half = find(coarse, mode.key.parity, mode.key.number)) {
      mode.eigenvalue_error = axisym::overestimate * std::abs(mode.eigenvalue - half->eigenvalue);
      mode.rate_error = axisym::overestimate * std::abs(mode.rate - half->rate);
    }
}

void warn(const std::vector<FoundMode>& modes, std::vector<std::string>& warnings) {
  const int m = modes.front().key.m;
  const auto any = [&](auto is) { return std::ranges::any_of(modes, is); };
  if (any([](const StateMode& mode) { return std::isnan(mode.rate); }))
    warnings.push_back(fmt::format("m = {}: not all rates are found", m));
  if (any([](const StateMode& mode) { return mode.rate * mode.eigenvalue > 0; }))
    warnings.push_back(fmt::format(
        "m = {}: rates and eigenvalues contradict each other; more elements may tell", m));
}

// The state over half as many elements, where there is one.
std::optional<axisym::SecondVariation> coarse_variation(const axisym::StationaryCase& of,
                                                        const axisym::StationaryState& state) {
  const auto coarse = axisym::on_elements(of.material, of.model, {state, of.at()},
                                          axisym::element_count(state.X) / 2, of.numerics.grading);
  if (!coarse) return {};
  return axisym::second_variation(of.material, of.model, *coarse);
}

}  // namespace

FoundModes find_modes(const ModesInput& input, const axisym::SecondVariation& second) {
  FoundModes found;
  const Physics physics{input.state.model, input.state.material};
  const axisym::LinearFlow flow(second, physics.material, physics.model);
  const auto half = coarse_variation(input.state, second.state);
  std::optional<axisym::LinearFlow> coarse;
  if (half) coarse.emplace(*half, physics.material, physics.model);
  for (int m = 0; m <= input.largest_m; ++m) {
    auto of_m = modes_of(input, physics, flow, m);
    if (!of_m)
      throw std::runtime_error(
          fmt::format("{}: the modes of m = {} are not found: use more elements in [numerics]",
                      text_of(input.state), m));
    if (coarse)
      if (auto less = modes_of(input, physics, *coarse, m))
        take_errors(of_m->modes, std::move(less->modes));
    found.rigid_residual = std::max(found.rigid_residual, of_m->rigid_residual);
    warn(of_m->modes, found.warnings);
    for (FoundMode& mode : of_m->modes) {
      normalise(mode.u, mode.b);
      found.modes.push_back(std::move(mode));
    }
  }
  return found;
}

}  // namespace sbeh::studies
